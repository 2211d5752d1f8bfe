// The parts of the pages of a stored run.
#include "io/serve/stored_site.h"

#include <nlohmann/json.hpp>

#include "io/serve/pair_site.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::test::stored_site_test {
namespace {

TEST_F(Results, site_of_a_run_has_every_frame) {
  StoredSite site(run, "1.2.3");
  EXPECT_EQ(site.frames(), 5U);
  const auto bytes = [&](std::string_view path) {
    const auto found = site.find(path);
    return found ? std::string(found->body->begin(), found->body->end()) : std::string();
  };
  const auto page = nlohmann::json::parse(bytes("/run.json"));
  EXPECT_EQ(page["title"], "A \"small\" run\\");
  ASSERT_EQ(page["frames"]["list"].size(), 5U);
  EXPECT_EQ(page["frames"]["meshes"], 2);
  EXPECT_EQ(page["frames"]["list"][2]["mesh"], 0);
  EXPECT_EQ(page["frames"]["list"][3]["mesh"], 1);
  EXPECT_EQ(page["frames"]["list"][3]["stage"], "fall");
  EXPECT_EQ(page["frames"]["list"][3]["integrator"], "implicit");
  EXPECT_DOUBLE_EQ(page["frames"]["list"][4]["time"], 2.0);
  EXPECT_NEAR(page["frames"]["ranges"]["speed"][1], 2.0, 1e-12);
  for (const char* path : {"/mesh/0", "/mesh/1", "/frame/0", "/frame/4", "/history", "/viewer.js", "/viewer.css"})
    EXPECT_FALSE(bytes(path).empty()) << path;
  EXPECT_EQ(bytes("/frame/1"), bytes("/frame/1"));
  EXPECT_NE(bytes("/frame/0"), bytes("/frame/4"));
  for (const char* path :
       {"/mesh/2", "/frame/5", "/frame/-1", "/run.vtkhdf", "/summary.json", "/frame", "", "run.json"})
    EXPECT_FALSE(site.find(path)) << path;
  const std::string html = bytes("/");
  EXPECT_NE(html.find("data-source=\"stored\""), std::string::npos);
  EXPECT_NE(html.find("A &quot;small&quot; run"), std::string::npos);
  // Scripts are loaded from the server; script elements in the page contain only data.
  for (std::size_t at = 0; (at = html.find("<script", at)) != std::string::npos; ++at) {
    const std::string tag = html.substr(at, html.find('>', at) - at);
    EXPECT_TRUE(tag == "<script src=\"viewer.js\"" || tag.find("type=\"text/plain\"") != std::string::npos) << tag;
  }
}

TEST_F(Results, two_runs_stand_side_by_side) {
  StoredSite left(run, "1"), right(run, "1");
  PairSite pair(left, right);
  const auto bytes = [](Site& site, std::string_view path) {
    const auto found = site.find(path);
    return found ? std::string(found->body->begin(), found->body->end()) : std::string();
  };
  const std::string page = bytes(pair, "/");
  EXPECT_NE(page.find("<iframe src=\"left/\" title=\"A &quot;small&quot; run\\\""), std::string::npos) << page;
  EXPECT_EQ(page.find("<script"), std::string::npos);
  for (const char* path : {"/", "/run.json", "/frame/3", "/mesh/1", "/viewer.js"}) {
    EXPECT_EQ(bytes(pair, std::string("/left") + path), bytes(left, path)) << path;
    EXPECT_EQ(bytes(pair, std::string("/right") + path), bytes(right, path)) << path;
  }
  for (const char* path :
       {"/run.json", "/left", "/leftrun.json", "/left/left/", "/middle/", "/left/../right/", "/right/frame/9"})
    EXPECT_FALSE(pair.find(path)) << path;
}

TEST_F(Results, site_of_no_run_is_refused) { EXPECT_THROW(StoredSite(scratch->path() / "nothing", "1"), FileError); }

}  // namespace
}  // namespace scree::io::test::stored_site_test
