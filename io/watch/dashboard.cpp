#include "io/watch/dashboard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "coupling/sink.h"
#include "io/text/printable.h"
#include "model/check.h"

namespace scree::io {
namespace {

using Lines = std::vector<std::string>;

std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string left(std::string_view text, std::size_t width) {
  std::string out = shown(text, width);
  out.append(width - columns(out), ' ');
  return out;
}

std::string right(std::string_view text, std::size_t width) {
  const std::string out = shown(text, width);
  return std::string(width - columns(out), ' ') + out;
}

/// Two texts at the ends of a line; the left one is shortened first.
std::string ends(std::string_view a, std::string_view b, std::size_t width) {
  const std::string tail = shown(b, width);
  const std::size_t room = width - columns(tail);
  return room < 2 ? tail : left(a, room - 1) + " " + tail;
}

/// A line with one or two facts; the second begins at the middle column of the screen.
std::string pair(std::string_view label, std::string_view a, std::string_view b, std::size_t width) {
  constexpr std::size_t kLabel = 9;
  const std::size_t half = std::max<std::size_t>(width / 2, 30);
  if (b.empty()) return left(label, kLabel) + shown(a, width - kLabel);
  if (half + 8 > width) return left(label, kLabel) + shown(fmt::format("{}  {}", a, b), width - kLabel);
  return left(label, kLabel) + left(a, half - kLabel - 1) + " " + shown(b, width - half);
}

std::string bar(double fraction, std::size_t width, char mark, char rest) {
  const double part = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
  const auto full = static_cast<std::size_t>(std::lround(part * static_cast<double>(width)));
  return std::string(full, mark) + std::string(width - full, rest);
}

std::string duration(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::clamp(std::ceil(seconds), 0.0, 9.0e8));
  if (whole < 120) return fmt::format("{} s", whole);
  if (whole < 7200) return fmt::format("{} min {:02d} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02d} min", whole / 3600, whole % 3600 / 60);
}

std::string count(std::optional<std::int64_t> n, std::string_view one, std::string_view many) {
  return n ? fmt::format("{} {}", *n, *n == 1 ? one : many) : std::string{};
}

std::string join(std::initializer_list<std::string> parts, std::string_view between) {
  std::string out;
  for (const std::string& part : parts) {
    if (part.empty()) continue;
    if (!out.empty()) out += between;
    out += part;
  }
  return out;
}

// --- sections -----------------------------------------------------------------------------------------------------

std::string status(const Dashboard& run) {
  constexpr double kSilence = 3.0;  // INFO is sent once per second
  if (!has_ended(run) && run.received && run.received->silent > kSilence)
    return fmt::format("silent for {}", duration(run.received->silent));
  return run.status;
}

Lines head(const Dashboard& run, std::size_t width) {
  Lines lines{ends("scree watch  " + run.run, status(run), width)};
  lines.push_back(shown(run.title.empty() ? "untitled case" : run.title, width));
  const double fraction = run.end_time > 0.0 ? run.time / run.end_time : 0.0;
  const std::string facts =
      fmt::format(" {:5.1f} %  {:.3f} of {:g} s", 100.0 * std::clamp(fraction, 0.0, 1.0), run.time, run.end_time);
  const std::string wait = run.time_left && run.status == "running" ? "  " + duration(*run.time_left) + " left" : "";
  const std::size_t text = columns(facts + wait);
  lines.push_back(text + 12 > width ? shown(facts.substr(1) + wait, width)
                                    : fmt::format("[{}]{}{}", bar(fraction, width - 2 - text, '#', '.'), facts, wait));
  lines.push_back(pair("stage", join({run.stage, run.integrator}, ", "),
                       join({run.rate ? fmt::format("rate {:.3g} s/s", *run.rate) : "",
                             run.step_rate ? fmt::format("{:.4g} steps/s", *run.step_rate) : ""},
                            ", "),
                       width));
  const bool passes_known = run.passes && run.steps && *run.steps > 0;
  lines.push_back(pair("steps",
                       join({run.steps ? std::to_string(*run.steps) : "", count(run.cuts, "cut", "cuts")}, ", "),
                       passes_known ? fmt::format("{:.1f} open-close passes a step",
                                                  static_cast<double>(*run.passes) / static_cast<double>(*run.steps))
                                    : "",
                       width));
  lines.push_back(pair("model",
                       join({count(run.blocks, "block", "blocks"), count(run.cells, "element", "elements")}, ", "),
                       count(run.unknowns, "unknown", "unknowns"), width));
  const auto contact_line = [&](std::string_view label, const std::string& value, const std::string& where) {
    lines.push_back(pair(label, join({value, where}, "  "), {}, width));
  };
  const std::string closed = run.contacts ? fmt::format("{} closed", *run.contacts) : "";
  if (!run.contact) {
    if (!closed.empty()) contact_line("contacts", closed, "");
  } else if (run.contact->depth_at.empty()) {
    contact_line("contacts", "none closed", "");
  } else {
    contact_line("contacts", join({closed, fmt::format("deepest {:.3g} m", run.contact->depth)}, ", "),
                 run.contact->depth_at);
    contact_line("", fmt::format("strongest {:.3g} N", run.contact->force), run.contact->force_at);
  }
  if (!run.reason.empty()) lines.push_back(pair("reason", run.reason, {}, width));
  return lines;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kSides{{{"energy", "energy held"},
                                                                               {"work", "work done on it"},
                                                                               {"dissipated", "dissipated"},
                                                                               {"scheme", "of the schemes"}}};

std::size_t energy_wish(const Dashboard::Ledger& ledger) {
  return 1 + kSides.size() +
         static_cast<std::size_t>(std::count_if(ledger.terms.begin(), ledger.terms.end(),
                                                [](const Dashboard::Term& t) { return t.value != 0.0; }));
}

/// A sum for each side, and below it the terms that are not zero; where there is no room the smallest ones are left
/// out.
Lines energy(const Dashboard::Ledger& ledger, std::size_t width, std::size_t height) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < ledger.terms.size(); ++i)
    if (ledger.terms[i].value != 0.0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(ledger.terms[a].value) > std::abs(ledger.terms[b].value);
  });
  const std::size_t room = height > 1 + kSides.size() ? height - 1 - kSides.size() : 0;
  const std::size_t omitted = order.size() > room ? order.size() - room : 0;
  order.resize(order.size() - omitted);
  std::sort(order.begin(), order.end());

  std::vector<std::pair<std::string, double>> rows;
  for (const auto& [side, title] : kSides) {
    double sum = 0.0;
    for (const Dashboard::Term& t : ledger.terms)
      if (t.side == side) sum += t.value;
    rows.emplace_back(title, sum);
    for (const std::size_t i : order)
      if (ledger.terms[i].side == side) {
        std::string name = "  " + ledger.terms[i].name;
        std::replace(name.begin(), name.end(), '_', ' ');
        rows.emplace_back(std::move(name), ledger.terms[i].value);
      }
  }
  double largest = 0.0;
  for (const auto& [name, value] : rows)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));

  constexpr std::size_t kName = 21, kValue = 11;
  const std::string closes = fmt::format("closes to {:.1e} of {:.3g} J moved", ledger.relative_closure, ledger.moved);
  Lines lines{ends(fmt::format("ENERGY [J] at {:.3f} s{}", ledger.time,
                               omitted > 0 ? fmt::format(" (and {} smaller)", omitted) : ""),
                   closes, width)};
  for (const auto& [name, value] : rows) {
    std::string line = left(name, kName) + right(fmt::format("{:.4g}", value), kValue) + " ";
    line +=
        bar(largest > 0.0 ? std::abs(value) / largest : 0.0, width - kName - kValue - 1, value < 0.0 ? '-' : '#', ' ');
    lines.push_back(std::move(line));
  }
  return lines;
}

Lines monitors(const Dashboard& run, std::size_t width, std::size_t height) {
  constexpr std::size_t kNumber = 12;
  const std::vector<Dashboard::Monitor>& all = run.monitors;
  const std::size_t rows = std::min(all.size(), height - 1);
  const std::size_t numbers = width >= 64 ? 4 : 2, name = width - numbers * kNumber;
  const auto line = [&](std::string_view first, const std::array<std::string, 4>& cells) {
    std::string text = left(first, name);
    for (const std::string& cell : std::span(cells).last(numbers)) text += right(cell, kNumber);
    return text;
  };
  const std::string of = rows < all.size() ? fmt::format(" ({} of {})", rows, all.size()) : "";
  Lines lines{line(fmt::format("MONITORS at {:.3f} s{}", run.monitors_time, of),
                   {"x [m]", "y [m]", "moved [m]", "speed [m/s]"})};
  for (const Dashboard::Monitor& m : std::span(all).first(rows))
    lines.push_back(line(
        "  " + m.name, {fmt::format("{:.3f}", m.x), fmt::format("{:.3f}", m.y),
                        fmt::format("{:.4g}", std::hypot(m.ux, m.uy)), fmt::format("{:.4g}", std::hypot(m.vx, m.vy))}));
  return lines;
}

/// Events as they are shown: step cuts, transfers and changes of a partition that follow one another are merged.
struct Happening {
  const Dashboard::Event* last = nullptr;
  int times = 0;
};
std::vector<Happening> happenings(const std::vector<Dashboard::Event>& events) {
  std::vector<Happening> result;
  for (const Dashboard::Event& e : events) {
    if (coupling::comes_often(e.kind) && !result.empty() && result.back().last->kind == e.kind)
      result.back() = {&e, result.back().times + 1};
    else
      result.push_back({&e, 1});
  }
  return result;
}

Lines events(const std::vector<Happening>& all, std::size_t width, std::size_t height) {
  const std::size_t rows = std::min(all.size(), height - 1);
  Lines lines{rows < all.size() ? fmt::format("EVENTS (the last {} of {})", rows, all.size()) : "EVENTS"};
  for (const auto& [e, times] : std::span(all).last(rows)) {
    std::string kind = e->kind;
    std::replace(kind.begin(), kind.end(), '_', ' ');
    const std::string often = times > 1 ? fmt::format("{} in a row, the last: ", times) : "";
    lines.push_back(
        shown(right(fmt::format("{:.3f} s", e->time), 12) + "  " + left(kind, 13) + " " + often + e->text, width));
  }
  return lines;
}

std::string foot(const Dashboard& run, std::size_t width) {
  if (!run.received) return shown(join({run.source, run.version.empty() ? "" : "scree " + run.version}, "  "), width);
  const Dashboard::Received& r = *run.received;
  std::string text = fmt::format("{} messages, {} malformed", r.messages, r.malformed);
  if (r.other > 0) text += fmt::format(", {} of older runs", r.other);
  if (r.incomplete > 0) text += fmt::format(", {} frames in part", r.incomplete);
  if (r.events_lost > 0) text += fmt::format(", {} events lost", r.events_lost);
  text += r.mesh_after ? fmt::format("  mesh after {:.1f} s", *r.mesh_after) : "  no mesh yet";
  if (run.frame_time) text += fmt::format(", frame {} at {:.3f} s", r.frames, *run.frame_time);
  return shown(text, width);
}

}  // namespace

std::string shown(std::string_view text, std::size_t most) {
  std::string out;
  std::size_t used = 0, last = 0;  // columns; byte where the last character begins
  while (!text.empty()) {
    if (used == most) {
      if (most > 0) out.replace(last, std::string::npos, "~");
      return out;
    }
    last = out.size();
    const std::size_t size = plain_length(text);
    out += size > 0 ? text.substr(0, size) : std::string_view("?");
    text.remove_prefix(std::max<std::size_t>(size, 1));
    ++used;
  }
  return out;
}

bool has_ended(const Dashboard& run) { return run.status != "running" && run.status != "paused"; }

std::vector<std::string> render(const Dashboard& run, int width, int height) {
  SCREE_ASSERT(width >= 40 && height >= 10);
  const auto across = static_cast<std::size_t>(width), down = static_cast<std::size_t>(height);
  if (run.run.empty()) {
    const double waited = run.received ? run.received->waited : 0.0;
    return {shown("scree watch", across),
            shown(fmt::format("waiting for a run on {}, {}", run.source, duration(waited)), across), foot(run, across)};
  }
  Lines lines = head(run, across);

  struct Section {
    std::size_t wish = 0, least = 0, given = 0;  // lines with the title, without the empty line above
  };
  std::array<Section, 3> sections;  // energy, monitors, events: the first section is dropped last
  if (run.ledger) sections[0] = {energy_wish(*run.ledger), 1 + kSides.size()};
  if (!run.monitors.empty()) sections[1] = {1 + run.monitors.size(), 2};
  const std::vector<Happening> happened = happenings(run.events);
  if (!happened.empty()) sections[2] = {1 + happened.size(), 2};
  std::size_t room = down > lines.size() + 1 ? down - lines.size() - 1 : 0;
  for (Section& s : sections)
    if (s.wish > 0 && room >= 1 + s.least) s.given = s.least, room -= 1 + s.least;
  // In turn, lists first up to a few lines each, so that the ledger is whole before they are.
  constexpr std::size_t kFew = 8;
  for (const std::size_t most_of_lists : {kFew, down})
    for (bool more = true; more && room > 0;) {
      more = false;
      for (std::size_t i = 0; i < sections.size(); ++i) {
        Section& s = sections[i];
        const std::size_t wish = i == 0 ? s.wish : std::min(s.wish, most_of_lists);
        if (s.given > 0 && s.given < wish && room > 0) ++s.given, --room, more = true;
      }
    }
  const auto add = [&](Lines&& section) {
    lines.emplace_back();
    lines.insert(lines.end(), section.begin(), section.end());
  };
  if (sections[0].given > 0) add(energy(*run.ledger, across, sections[0].given));
  if (sections[1].given > 0) add(monitors(run, across, sections[1].given));
  if (sections[2].given > 0) add(events(happened, across, sections[2].given));
  if (lines.size() > down - 1) lines.resize(down - 1);
  lines.push_back(foot(run, across));
  for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
  return lines;
}

std::string render_line(const Dashboard& run) {
  if (run.run.empty()) return fmt::format("waiting for a run on {}", run.source);
  double held = 0.0;
  if (run.ledger)
    for (const Dashboard::Term& t : run.ledger->terms)
      if (t.side == "energy") held += t.value;
  const std::string line =
      join({fmt::format("{:.3f}/{:g} s", run.time, run.end_time), run.stage, status(run),
            count(run.steps, "step", "steps"), run.rate ? fmt::format("{:.3g} s/s", *run.rate) : "",
            run.time_left && run.status == "running" ? duration(*run.time_left) + " left" : "",
            run.ledger ? fmt::format("held {:.4g} J", held) : "",
            run.ledger ? fmt::format("ledger {:.0e}", run.ledger->relative_closure) : "",
            run.received && run.received->malformed > 0 ? fmt::format("{} malformed", run.received->malformed) : ""},
           "  ");
  return shown(line, 200);
}

}  // namespace scree::io
