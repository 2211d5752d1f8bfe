// The page of a report: its chunks are read back and compared, and no text of a run becomes HTML.
#include "io/report/report.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "io/report/chunk.h"
#include "io/report/frames.h"
#include "io/report/gallery.h"
#include "io/report/page.h"
#include "io/report/run_text.h"
#include "io/viewer/bundle.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::test::report_test {
namespace {

std::vector<std::uint8_t> from_base64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> out;
  std::uint32_t word = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    word = word << 6U | static_cast<std::uint32_t>(kDigits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    out.push_back(static_cast<std::uint8_t>(word >> bits));
  }
  return out;
}

/// Arrays of a chunk as numbers, decoded independently from the layout that chunk.h describes.
std::map<std::string, std::vector<double>> unpacked(std::string_view text) {
  const std::vector<std::uint8_t> packed = from_base64(text);
  std::vector<std::uint8_t> bytes(1U << 20U);
  uLongf size = bytes.size();
  EXPECT_EQ(uncompress(bytes.data(), &size, packed.data(), packed.size()), Z_OK);
  bytes.resize(size);
  const auto word = [&](std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8U |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16U | static_cast<std::uint32_t>(bytes[at + 3]) << 24U;
  };
  std::map<std::string, std::vector<double>> arrays;
  const std::uint32_t count = word(0);
  std::size_t at = 4 + 24 * static_cast<std::size_t>(count);
  for (std::size_t a = 0; a < count; ++a) {
    const std::size_t head = 4 + 24 * a;
    const std::string name(reinterpret_cast<const char*>(&bytes[head]));
    const std::uint32_t type = word(head + 16);
    const std::size_t length = word(head + 20);
    std::vector<double>& out = arrays[name];
    for (std::size_t i = 0; i < length; ++i) {
      if (type == 2) {
        out.push_back(bytes[at + i]);
        continue;
      }
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 4; ++k) bits |= static_cast<std::uint32_t>(bytes[at + k * length + i]) << (8 * k);
      out.push_back(type == 0 ? static_cast<double>(std::bit_cast<float>(bits))
                              : static_cast<double>(std::bit_cast<std::int32_t>(bits)));
    }
    at += (type == 2 ? 1 : 4) * length;
  }
  EXPECT_EQ(at, bytes.size());
  return arrays;
}

/// Text of the element with an id.
std::string element(const std::string& html, const std::string& id) {
  const std::size_t at = html.find("id=\"scree-" + id + "\">");
  if (at == std::string::npos) return {};
  const std::size_t from = html.find('>', at) + 1;
  return html.substr(from, html.find("</script>", from) - from);
}

TEST(ReportChunk, base64_of_rfc4648_vectors) {
  const auto of = [](std::string_view text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

TEST(ReportChunk, arrays_return_to_the_bit) {
  const std::vector<float> numbers{0.0F, -1.5F, 3.1415927F, 1e-38F, std::numeric_limits<float>::infinity()};
  const std::vector<std::int32_t> ids{-1, 0, 70000};
  const std::vector<std::uint8_t> small{0, 255, 3};
  Chunk chunk;
  chunk.add("numbers", std::span<const float>(numbers));
  chunk.add("ids", std::span<const std::int32_t>(ids));
  chunk.add("small", std::span<const std::uint8_t>(small));
  chunk.add("none", std::span<const float>());
  const auto back = unpacked(chunk.text());
  ASSERT_EQ(back.size(), 4U);
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(back.at("numbers")[i], static_cast<double>(numbers[i]));
  EXPECT_EQ(back.at("ids"), (std::vector<double>{-1, 0, 70000}));
  EXPECT_EQ(back.at("small"), (std::vector<double>{0, 255, 3}));
  EXPECT_TRUE(back.at("none").empty());
}

TEST(ReportChunk, rounded_is_within_half_of_the_last_bit_kept) {
  for (const double x : {1.0, -1.0 / 3.0, 12345.678, 1e-20, 3.9999, -7.77e30}) {
    const float r = rounded(x, 11);
    EXPECT_LE(std::abs(static_cast<double>(r) - x), std::abs(x) * std::ldexp(1.0, -12) * 1.001) << x;
    EXPECT_EQ(std::bit_cast<std::uint32_t>(r) & 0xFFFU, 0U) << x;
  }
  EXPECT_EQ(rounded(0.1, 23), 0.1F);
  EXPECT_EQ(rounded(0.0, 11), 0.0F);
  EXPECT_EQ(rounded(std::numeric_limits<float>::max(), 11), std::numeric_limits<float>::max());
  EXPECT_TRUE(std::isnan(rounded(std::numeric_limits<double>::quiet_NaN(), 11)));
}

TEST(ReportFrames, thinning_keeps_the_ends) {
  EXPECT_EQ(thinned({1, 0, 0, 1, 1, 0, 0, 0, 1}, 1), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(thinned({1, 0, 0, 1, 1, 0, 0, 0, 1}, 3), (std::vector<std::size_t>{0, 3, 4, 6, 8}));
  EXPECT_EQ(thinned({1, 0, 0, 1, 1, 0, 0, 0, 1}, 100), (std::vector<std::size_t>{0, 3, 4, 8}));
}

TEST_F(Results, report_frames_hold_positions_speeds_and_stresses) {
  const RunReader reader(run);
  const Vec2 base(5.0, 0.0);
  const ReportFrames packed = pack_frames(reader, base, 0);
  ASSERT_EQ(packed.frames.size(), reader.times().size());
  ASSERT_EQ(packed.meshes.size(), 2U);  // triangles, then one rectangle
  EXPECT_EQ(packed.frames[2].mesh, 0U);
  EXPECT_EQ(packed.frames[3].mesh, 1U);
  EXPECT_EQ(packed.frames[3].stage, "fall");
  for (std::size_t i = 0; i < packed.frames.size(); ++i) {
    const StoredFrame f = reader.frame(i);
    const auto frame = unpacked(packed.frames[i].text), mesh = unpacked(packed.meshes[packed.frames[i].mesh]);
    ASSERT_EQ(mesh.at("origin").size(), f.position.size());
    ASSERT_EQ(mesh.at("cells").size(), f.connectivity.size());
    for (std::size_t k = 0; k < f.position.size(); ++k) {
      // Tolerance: float32 of numbers up to 10 m, and 17 significant bits of the displacement.
      EXPECT_NEAR(mesh.at("origin")[k] + frame.at("displacement")[k] + base[static_cast<Eigen::Index>(k % 2)],
                  f.position[k], 2e-6 + std::abs(f.displacement[k]) / 131072.0);
      EXPECT_NEAR(frame.at("velocity")[k], f.velocity[k], std::abs(f.velocity[k]) / 4096.0);
    }
    for (std::size_t c = 0; c < f.cells(); ++c) {
      EXPECT_EQ(mesh.at("block")[c], f.block[c]);
      EXPECT_EQ(mesh.at("method")[c], f.method[c]);
      EXPECT_EQ(frame.at("integrator")[c], f.cell_integrator[c]);
      // The stress is uniform in the model: the stress recovered at points equals that of the cells.
      const auto p = static_cast<std::size_t>(f.connectivity[static_cast<std::size_t>(f.offsets[c])]);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(frame.at("stress")[3 * p + k], f.stress[3 * c + k], std::abs(f.stress[3 * c + k]) / 4000.0);
    }
  }
}

TEST_F(Results, report_ranges_leave_out_held_blocks) {
  const RunReader reader(run);
  const ReportFrames packed = pack_frames(reader, {0.0, 0.0}, 0);
  std::map<std::string, std::pair<double, double>> ranges;
  for (const ReportRange& r : packed.ranges) ranges[r.field] = {r.low, r.high};
  EXPECT_DOUBLE_EQ(ranges.at("displacement").first, 0.0);
  EXPECT_NEAR(ranges.at("displacement").second, 0.2 * std::sqrt(5.0), 1e-12);  // (d, 2 d) at the end, d = 0.2
  EXPECT_NEAR(ranges.at("speed").second, 2.0, 1e-12);
  EXPECT_NEAR(ranges.at("uy").second, 0.4, 1e-12);
  EXPECT_NEAR(ranges.at("uy").first, -0.4, 1e-12);
  EXPECT_NEAR(ranges.at("shear").second, 8e6, 1.0);  // (s, -3 s) with s = -4e6
}

TEST_F(Results, report_thins_to_its_size_and_says_so) {
  const RunReader reader(run);
  const ReportFrames packed = pack_frames(reader, {0.0, 0.0}, 1);
  EXPECT_EQ(packed.stored, 5U);
  std::vector<std::size_t> kept;
  for (const ReportFrame& f : packed.frames) kept.push_back(f.index);
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 2, 3, 4}));  // first and last frame of each mesh
}

TEST_F(Results, report_is_one_page_with_everything) {
  const fs::path file = scratch->path() / "page.html";
  const ReportNote note = write_report(run, {5.0, "1.2.3"}, file);
  const std::string html = text_of(file);
  EXPECT_EQ(note.shown, 5U);
  EXPECT_EQ(note.bytes, html.size());
  const auto page = nlohmann::json::parse(element(html, "run"));
  EXPECT_EQ(page["title"], "A \"small\" run\\");
  EXPECT_EQ(page["frames"]["list"].size(), 5U);
  EXPECT_EQ(page["frames"]["list"][3]["stage"], "fall");
  EXPECT_EQ(page["model"]["blocks"][0]["held"], true);
  EXPECT_EQ(page["model"]["joints"]["lines"].size(), 1U);
  EXPECT_EQ(page["model"]["joints"]["cracks"].size(), 1U);
  EXPECT_EQ(page["asked"]["case"], "title = \"ä\"\n");
  EXPECT_EQ(page["asked"]["command_line"], "scree run case.toml");
  EXPECT_EQ(page["found"]["status"], "done");
  EXPECT_EQ(page["history"]["monitors"][1]["name"], "crest, left_2");
  const auto rows = unpacked(element(html, "history"));
  EXPECT_EQ(rows.at("m1.time").size(), 5U);
  EXPECT_NEAR(rows.at("m1.s").back(), 6e6, 1.0);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_FALSE(element(html, "frame-" + std::to_string(i)).empty());
  EXPECT_FALSE(element(html, "mesh-1").empty());
  // No external content: no address in an attribute of an element, and a policy that forbids requests.
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  const std::string body = html.substr(0, html.find("<script"));
  for (const char* word : {"src", "href"})
    for (std::size_t at = body.find(word); at != std::string::npos; at = body.find(word, at + 1)) {
      const std::size_t after = body.find_first_not_of(" \t\n", at + std::strlen(word));
      EXPECT_TRUE(after == std::string::npos || body[after] != '=') << body.substr(at, 80);
    }
}

TEST_F(Results, report_without_a_summary_has_none) {
  const fs::path copy = scratch->path() / "killed";
  fs::copy(run, copy);
  fs::remove(copy / "summary.json");
  const fs::path file = scratch->path() / "killed.html";
  write_report(copy, {0.0, "1"}, file);
  EXPECT_TRUE(nlohmann::json::parse(element(text_of(file), "run"))["found"].is_null());
  std::ofstream(copy / "summary.json") << "{\"status\": ";
  write_report(copy, {0.0, "1"}, file);
  EXPECT_TRUE(nlohmann::json::parse(element(text_of(file), "run"))["found"].is_null());
}

TEST_F(Results, report_of_no_run_is_refused) {
  EXPECT_THROW(write_report(scratch->path() / "nothing", {5.0, "1"}, scratch->path() / "x.html"), FileError);
  EXPECT_FALSE(fs::exists(scratch->path() / "x.html"));
  EXPECT_THROW(write_report(run, {5.0, "1"}, scratch->path() / "no" / "folder" / "x.html"), FileError);
}

TEST_F(Results, reader_gives_joints_stages_and_the_case) {
  const RunReader reader(run);
  const StoredJoints joints = reader.joints();
  ASSERT_EQ(joints.laws.size(), 1U);
  EXPECT_EQ(joints.laws[0].name, "rough");
  ASSERT_EQ(joints.lines.size(), 1U);
  EXPECT_EQ(joints.lines[0].to, Vec2(6.0, 1.5));
  EXPECT_EQ(joints.cracks[0].to, Vec2(5.0, 1.25));
  EXPECT_EQ(reader.provenance_list("case"), std::vector<std::string>{"title = \"ä\"\n"});
  EXPECT_TRUE(reader.provenance_list("set").empty());
  EXPECT_DOUBLE_EQ(reader.stages()[1].duration, 1.0);
  EXPECT_DOUBLE_EQ(reader.materials()[0].density, 2600.0);
  EXPECT_FALSE(reader.has_contacts());
  EXPECT_TRUE(reader.supports().empty());
}

TEST(Report, point_supports_return_from_the_results) {
  const Scratch scratch;
  SmallRun small;
  small.model.point_supports.push_back({BlockId{1}, {4.0, 0.5}, false, true, {}});
  {
    ResultsSink sink(RunFolder::create(scratch.path() / "run", false), provenance());
    small.play(sink);
  }
  const std::vector<StoredSupport> supports = RunReader(scratch.path() / "run").supports();
  ASSERT_EQ(supports.size(), 1U);
  EXPECT_EQ(supports[0].point, Vec2(4.0, 0.5));
  EXPECT_FALSE(supports[0].fix_x);
  EXPECT_TRUE(supports[0].fix_y);
}

TEST(Report, water_returns_from_the_results) {
  const Scratch scratch;
  SmallRun small;
  small.model.joints.resize(2);
  small.model.waters.push_back({{{0.0, 1.5}, {4.0, 2.5}}, 9810.0, {JointId{1}}});
  small.model.waters.push_back({{{-1.0, 0.5}, {2.0, 0.5}, {3.0, 0.75}}, 10e3, {}});
  {
    ResultsSink sink(RunFolder::create(scratch.path() / "run", false), provenance());
    small.play(sink);
  }
  const RunReader run(scratch.path() / "run");
  const std::vector<StoredWater> waters = run.waters();
  ASSERT_EQ(waters.size(), 2U);
  EXPECT_EQ(waters[0].line, small.model.waters[0].line);
  EXPECT_EQ(waters[0].joints, std::vector<std::int32_t>{1});
  EXPECT_EQ(waters[1].line, small.model.waters[1].line);
  EXPECT_TRUE(waters[1].joints.empty()) << "all";
  const RunText text(run, scratch.path() / "run", "1");
  const auto page = nlohmann::json::parse(text.text());
  const Vec2& base = text.base();
  EXPECT_EQ(page["model"]["water"][0]["joints"], nlohmann::json({1}));
  EXPECT_NEAR(page["model"]["water"][1]["line"][4].get<double>(), 3.0 - base.x(), 1e-6);
  EXPECT_NEAR(page["model"]["water"][1]["line"][5].get<double>(), 0.75 - base.y(), 1e-6);
}

TEST(Report, gallery_has_a_card_a_run_and_its_text_stays_text) {
  const Scratch scratch;
  SmallRun small;
  small.model.title = "</title><script>x</script> slope & wall";
  {
    ResultsSink sink(RunFolder::create(scratch.path() / "run", false), provenance());
    small.play(sink);
  }
  GalleryCard card = gallery_card(scratch.path() / "run", scratch.path() / "run.png", "run.html");
  card.name = "run <1>";
  EXPECT_EQ(from_base64(card.picture).at(1), 'P');
  EXPECT_EQ(card.facts[0].second, "done");
  const GalleryCard broken{"broken", "", "", "", {}, "run.vtkhdf <i>cannot</i> be read"};
  const std::string html = gallery_page({card, broken}, "0.1.0");
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("<i>"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;x&lt;/script&gt; slope &amp; wall"), std::string::npos);
  EXPECT_NE(html.find("href=\"run.html\""), std::string::npos);
  EXPECT_NE(html.find("alt=\"The blocks of run &lt;1&gt; at the end"), std::string::npos);
  EXPECT_NE(html.find("cannot&lt;/i&gt; be read"), std::string::npos);
  EXPECT_THROW((void)gallery_card(scratch.path() / "none", scratch.path() / "n.png", ""), FileError);
}

TEST(Report, hostile_text_stays_text) {
  const std::string evil = "</script><script>alert(1)</script><!--<img src=x onerror=alert(2)>&quot;\xff";
  const Scratch scratch;
  SmallRun small;
  small.model.title = evil;
  small.model.blocks[1].name = evil;
  small.plan.stages[0].name = evil;
  Provenance p = provenance();
  p.case_text = p.command_line = evil;
  {
    ResultsSink sink(RunFolder::create(scratch.path() / "run", false), p);
    small.play(sink);
  }
  const fs::path file = scratch.path() / "r.html";
  write_report(scratch.path() / "run", {5.0, evil}, file);
  const std::string html = text_of(file);
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(html.find("<!--<"), std::string::npos);
  const std::string json = element(html, "run");
  EXPECT_EQ(json.find('<'), std::string::npos);
  const auto page = nlohmann::json::parse(json);
  const std::string back = page["model"]["blocks"][1]["name"];
  EXPECT_EQ(back.substr(0, 30), evil.substr(0, 30));
}

TEST(Report, html_text_has_no_markup) {
  EXPECT_EQ(html_text("<a href=\"x\" title='y'>&"), "&lt;a href=&quot;x&quot; title=&#39;y&#39;&gt;&amp;");
  EXPECT_EQ(json_in_html("{\"a\":\"</script>&\"}"), "{\"a\":\"\\u003c/script\\u003e\\u0026\"}");
}

TEST(Report, bundle_is_ascii_and_ends_no_script) {
  for (const std::string_view part : {viewer_script(), viewer_style(), viewer_body(), viewer_licences()}) {
    EXPECT_FALSE(part.empty());
    EXPECT_TRUE(
        std::all_of(part.begin(), part.end(), [](char c) { return c == '\n' || c == '\t' || (c >= ' ' && c < 127); }));
  }
  EXPECT_EQ(viewer_script().find("</script"), std::string_view::npos);
  EXPECT_EQ(viewer_style().find("</style"), std::string_view::npos);
  for (const char* name : {"three ", "earcut ", "uplot "})
    EXPECT_NE(viewer_licences().find(name), std::string_view::npos) << name;
}

}  // namespace
}  // namespace scree::io::test::report_test
