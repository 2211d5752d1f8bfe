// The stream of the server to viewers: WebSocket, access, and the treatment of slow or faulty viewers.
#include <algorithm>

#include "tests/unit/io/serve_client.h"

namespace scree::io::test::serve_stream_test {
namespace {

TEST(Server, a_stream_wants_the_origin_of_its_page) {
  SmallSite site(3);
  Served served(site);
  const std::uint16_t port = served.port();
  EXPECT_EQ(status_of(reply(port, upgrade(port, "http://evil.example"))), 403);
  EXPECT_EQ(status_of(reply(port, upgrade(port, ""))), 403);
  EXPECT_EQ(status_of(reply(port, get(port, "/live"))), 426);
  EXPECT_TRUE(LiveClient(port).good);
}

TEST(Server, a_late_viewer_gets_the_newest_of_each_first_things_first) {
  SmallSite site(3);
  site.versions = 4;
  Served served(site);
  LiveClient late(served.port());
  ASSERT_TRUE(late.good);
  std::vector<std::string> got = late.next(3);
  ASSERT_EQ(got.size(), 3U);
  EXPECT_EQ(got[0], "a4");
  std::sort(got.begin(), got.end());
  EXPECT_EQ(got, (std::vector<std::string>{"a4", "b4", "c4"}));
  site.versions = 5;
  got = late.next(3);
  ASSERT_EQ(got.size(), 3U);
  EXPECT_EQ(got[0], "a5");
}

TEST(Server, a_viewer_that_does_not_take_frames_gets_two_and_later_the_newest) {
  SmallSite site(2);  // "b" is paced
  Served served(site);
  LiveClient slow(served.port()), quick(served.port());
  std::vector<std::string> paced, all;
  for (int version = 1; version <= 6; ++version) {
    site.versions = version;
    for (const std::string& message : slow.next(version <= 2 ? 2 : 1))
      if (message.front() == 'b') paced.push_back(message);
    for (const std::string& message : quick.next(2)) {
      if (message.front() != 'b') continue;
      all.push_back(message);
      quick.client.send(ws_frame("n"));
    }
  }
  EXPECT_EQ(paced, (std::vector<std::string>{"b1", "b2"}));
  EXPECT_EQ(slow.next(1, 150ms), std::vector<std::string>());
  EXPECT_EQ(all, (std::vector<std::string>{"b1", "b2", "b3", "b4", "b5", "b6"}));
  slow.client.send(ws_frame("n"));
  EXPECT_EQ(slow.next(1), std::vector<std::string>{"b6"});
}

TEST(Server, a_viewer_that_reads_nothing_holds_up_nobody) {
  SmallSite site(1);
  site.filling.assign(1 << 20U, 'x');
  Served served(site);
  LiveClient stuck(served.port(), 4096), quick(served.port());
  for (int version = 1; version <= 20; ++version) {
    site.versions = version;
    const std::vector<std::string> got = quick.next(1);
    ASSERT_EQ(got.size(), 1U);
    EXPECT_EQ(got[0].substr(0, got[0].find('x')), "a" + std::to_string(version));
  }
  // When the viewer reads again, it gets the message that was being sent, then the newest.
  const std::vector<std::string> late = stuck.next(2);
  ASSERT_EQ(late.size(), 2U);
  EXPECT_EQ(late[0].substr(0, 2), "a1");
  EXPECT_EQ(late[1].substr(0, 3), "a20");
}

TEST(Server, wrong_messages_of_a_viewer_end_its_connection) {
  SmallSite site(2);
  site.versions = 1;
  Served served(site);
  const std::string too_long =
      std::string("\x81\xFF\x7F\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 10) + "maskdata";  // 2^63 - 1 bytes
  const std::string over_limit = std::string("\x81\xFE\x20\x00mask", 8) + std::string(8192, 'x');
  const std::vector<std::string> wrong{
      ws_frame("stop"),
      ws_frame(""),
      ws_frame("nn"),
      ws_frame("n") + ws_frame("n") + ws_frame("n"),
      std::string("\x81\x01n", 3),  // not masked
      ws_frame("n", 3),
      ws_frame("n", 11),                                                // undefined codes
      std::string("\xF1\x81maskn", 7),                                  // reserved bits
      std::string("\x01\x80mask", 6) + ws_frame("n"),                   // a message within a message
      ws_frame(std::string(126 - 1, 'p'), 9).replace(0, 1, 1, '\x09'),  // a ping in pieces
      ws_frame("\xFF\xFE"),
      too_long,
      over_limit};
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    LiveClient viewer(served.port());
    ASSERT_TRUE(viewer.good) << i;
    viewer.next(2);
    viewer.client.got().clear();
    viewer.client.send(wrong[i]);
    viewer.client.take([](const std::string& text) { return text.size() >= 2; });
    EXPECT_EQ(viewer.client.got().substr(0, 1), "\x88") << i << ": the server does not close";
  }
  LiveClient good(served.port());
  EXPECT_EQ(good.next(2).size(), 2U);
  EXPECT_GE(served.counts().refused, 5);
}

}  // namespace
}  // namespace scree::io::test::serve_stream_test
