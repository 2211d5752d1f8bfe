// Utilisation of rock strength, compared with hand calculations of the Mohr-Coulomb and Hoek-Brown criteria.
#include "model/rock_strength.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace scree::rock_strength_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// Uniaxial strength 2 c cos(phi)/(1 - sin(phi)), by hand 3.4641 MPa for 1 MPa and 30 degrees; it grows by (1 + sin)/(1
// - sin) = 3 times the confinement.
TEST(RockStrength, mohr_coulomb_has_the_strengths_of_the_book) {
  const MohrCoulombStrength m{1e6, 30.0 * kDegree, 1e6 / std::tan(30.0 * kDegree)};
  const double uniaxial = 2e6 * std::sqrt(3.0);
  EXPECT_NEAR(utilisation(m, 0.0, -uniaxial), 1.0, 1e-12);
  EXPECT_NEAR(utilisation(m, -1e6, -uniaxial - 3e6), 1.0, 1e-12);
  // half the strength: circle of radius 0.8660 MPa about 0.8660 MPa; the envelope there admits 0.8660 + 0.4330 MPa
  EXPECT_NEAR(utilisation(m, 0.0, -0.5 * uniaxial), 2.0 / 3.0, 1e-12);
  EXPECT_EQ(utilisation(m, -2e6, -2e6), 0.0);
}

TEST(RockStrength, a_tension_cut_off_governs_where_it_is_low) {
  const MohrCoulombStrength m{1e6, 30.0 * kDegree, 0.5e6};
  EXPECT_NEAR(utilisation(m, 1e6, 0.0), 2.0, 1e-12);
  EXPECT_NEAR(utilisation(m, 0.25e6, 0.25e6), 0.5, 1e-12);
  EXPECT_EQ(utilisation(MohrCoulombStrength{1e6, 30.0 * kDegree, 0.0}, 1.0, 0.0), kMostUtilisation);
}

TEST(RockStrength, beyond_the_end_of_the_envelope_all_strength_is_taken) {
  const MohrCoulombStrength m{1e6, 45.0 * kDegree, 1e6};
  EXPECT_EQ(utilisation(m, 3e6, 1e6), kMostUtilisation);  // centre beyond the tip of the envelope: no circle fits
}

TEST(RockStrength, hoek_brown_of_intact_rock_has_its_uniaxial_and_confined_strengths) {
  const HoekBrownStrength h = HoekBrownStrength::of_rock_mass(50e6, 100.0, 10.0, 0.0);
  EXPECT_NEAR(h.mb, 10.0, 1e-12);
  EXPECT_NEAR(h.s, 1.0, 1e-12);
  EXPECT_NEAR(h.a, 0.5, 1e-12);
  EXPECT_NEAR(utilisation(h, 0.0, -50e6), 1.0, 1e-9);
  EXPECT_NEAR(utilisation(h, -5e6, -(5e6 + 50e6 * std::sqrt(2.0))), 1.0, 1e-9);  // 5 + 50 sqrt(10 5/50 + 1) MPa
  EXPECT_NEAR(utilisation(h, 2.5e6, 2.5e6), 0.5, 1e-12);                         // tension s ucs/m_b = 5 MPa
}

// GSI 45, m_i 10, D 0: m_b = 10 exp(-55/28) = 1.4027, s = exp(-55/9) = 0.002218, a = 0.5081 (equal to the digits of
// Hoek's 2002 example).
TEST(RockStrength, hoek_brown_of_a_rock_mass_has_the_constants_of_the_source) {
  const HoekBrownStrength h = HoekBrownStrength::of_rock_mass(50e6, 45.0, 10.0, 0.0);
  EXPECT_NEAR(h.mb, 1.403, 1e-3);
  EXPECT_NEAR(h.s, 0.00222, 1e-5);
  EXPECT_NEAR(h.a, 0.508, 2e-4);
  EXPECT_NEAR(utilisation(h, 0.0, -50e6 * std::pow(h.s, h.a)), 1.0, 1e-9);
  const HoekBrownStrength disturbed = HoekBrownStrength::of_rock_mass(50e6, 45.0, 10.0, 1.0);
  EXPECT_NEAR(disturbed.mb, 10.0 * std::exp(-55.0 / 14.0), 1e-12);
  EXPECT_GT(utilisation(disturbed, -1e5, -1e6), utilisation(h, -1e5, -1e6));
}

}  // namespace
}  // namespace scree::rock_strength_test
