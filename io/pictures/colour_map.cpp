#include "io/pictures/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace scree::io {

namespace {

using Rgb = std::array<unsigned char, 3>;

// Viridis of matplotlib (CC0), every fifteenth of its 256 colours, joined by straight lines.
constexpr std::array<Rgb, 18> kViridis{{{68, 1, 84},
                                        {72, 23, 105},
                                        {71, 42, 122},
                                        {67, 61, 132},
                                        {61, 78, 138},
                                        {53, 94, 141},
                                        {46, 109, 142},
                                        {41, 123, 142},
                                        {35, 137, 142},
                                        {31, 151, 139},
                                        {33, 165, 133},
                                        {46, 179, 124},
                                        {70, 192, 111},
                                        {101, 203, 94},
                                        {137, 213, 72},
                                        {176, 221, 47},
                                        {216, 226, 25},
                                        {253, 231, 37}}};

// RdBu of ColorBrewer 2.0 (Apache 2.0, C. Brewer), reversed: blue below zero, red above.
constexpr std::array<Rgb, 11> kBlueRed{{{5, 48, 97},
                                        {34, 103, 172},
                                        {67, 147, 195},
                                        {144, 196, 221},
                                        {209, 229, 240},
                                        {247, 246, 246},
                                        {253, 219, 199},
                                        {244, 166, 131},
                                        {214, 96, 77},
                                        {177, 24, 43},
                                        {103, 0, 31}}};

// Okabe and Ito 2008 without black, distinguished by colour-blind readers; then darker ones for long lists.
constexpr std::array<Rgb, 14> kDistinct{{{0, 114, 178},
                                         {230, 159, 0},
                                         {0, 158, 115},
                                         {204, 121, 167},
                                         {86, 180, 233},
                                         {213, 94, 0},
                                         {190, 180, 40},
                                         {120, 94, 160},
                                         {140, 105, 70},
                                         {95, 95, 95},
                                         {0, 80, 75},
                                         {150, 20, 50},
                                         {150, 190, 110},
                                         {35, 45, 110}}};

Colour between(std::span<const Rgb> map, double t) {
  const double x = std::clamp(t, 0.0, 1.0) * static_cast<double>(map.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(x), map.size() - 2);
  const double f = x - static_cast<double>(i);
  const auto mix = [&](std::size_t c) { return ((1.0 - f) * map[i][c] + f * map[i + 1][c]) / 255.0; };
  return {mix(0), mix(1), mix(2)};
}

}  // namespace

Colour sequential_colour(double t) { return between(kViridis, t); }
Colour diverging_colour(double t) { return between(kBlueRed, t); }

Colour distinct_colour(std::size_t number) {
  // The second round is paler, the third darker: a white or black share of each colour.
  struct Mix {
    double white, own;
  };
  constexpr std::array<Mix, 3> kRound{{{0.0, 1.0}, {0.55, 0.45}, {0.0, 0.6}}};
  const Rgb& c = kDistinct[number % kDistinct.size()];
  const Mix& mix = kRound[number / kDistinct.size() % kRound.size()];
  const auto part = [&](std::size_t i) { return mix.white + mix.own * c[i] / 255.0; };
  return {part(0), part(1), part(2)};
}

}  // namespace scree::io
