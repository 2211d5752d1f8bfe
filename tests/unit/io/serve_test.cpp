// The server of `scree view`: its answers, its refusals, and that no input ends it. Requests are written by hand over
// plain sockets, so that the code under test has no part in the test.
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "io/serve/request_rules.h"
#include "tests/unit/io/serve_client.h"

namespace scree::io::test::serve_test {
namespace {

TEST(ServeRules, host_and_origin_are_this_server_alone) {
  for (const char* good : {"127.0.0.1:8080", "localhost:8080"}) {
    EXPECT_TRUE(host_is_ours(good, 8080)) << good;
    EXPECT_TRUE(origin_is_ours(std::string("http://") + good, 8080)) << good;
  }
  for (const char* bad :
       {"", "127.0.0.1", "localhost", "127.0.0.1:80", "127.0.0.1:80800", "127.0.0.1:8080 ", "127.0.0.2:8080",
        "evil.example:8080", "127.0.0.1:8080.evil.example", "localhost:8080@evil", "LOCALHOST:8080 x"}) {
    EXPECT_FALSE(host_is_ours(bad, 8080)) << bad;
    EXPECT_FALSE(origin_is_ours(std::string("http://") + bad, 8080)) << bad;
  }
  for (const char* bad : {"null", "", "https://127.0.0.1:8080", "http://127.0.0.1:8080/", "file://", "127.0.0.1:8080"})
    EXPECT_FALSE(origin_is_ours(bad, 8080)) << bad;
}

TEST(ServeRules, number_of_path_takes_plain_numbers) {
  EXPECT_EQ(number_of_path("/frame/0", "/frame/"), 0U);
  EXPECT_EQ(number_of_path("/frame/120", "/frame/"), 120U);
  for (const char* bad :
       {"/frame/", "/frame/00", "/frame/01", "/frame/-1", "/frame/+1", "/frame/1/", "/frame/1?", "/frame/ 1",
        "/frame/1e3", "/frame/0x1", "/frame/9999999999", "/frame/%31", "/mesh/1", "frame/1", "/frame/../1"})
    EXPECT_FALSE(number_of_path(bad, "/frame/")) << bad;
}

TEST(Server, answers_what_the_site_has) {
  SmallSite site;
  Served served(site);
  const std::uint16_t port = served.port();
  const std::string good = reply(port, get(port, "/"));
  EXPECT_EQ(status_of(good), 200);
  EXPECT_EQ(body_of(good), kWords);
  for (const char* header :
       {"Content-Security-Policy: default-src 'none'; script-src 'self'", "X-Content-Type-Options: nosniff",
        "Referrer-Policy: no-referrer", "Cross-Origin-Resource-Policy: same-origin", "Cache-Control: no-store",
        "Content-Type: text/plain", "Content-Length: 11"})
    EXPECT_NE(good.find(header), std::string::npos) << header;
  EXPECT_EQ(good.find("unsafe-inline"), std::string::npos);
  const std::string head = reply(port, get(port, "/", "", "HEAD"));
  EXPECT_EQ(status_of(head), 200);
  EXPECT_NE(head.find("Content-Length: 11"), std::string::npos);
  EXPECT_EQ(body_of(head), "");
  EXPECT_EQ(status_of(reply(port, get(port, "/", "Origin: http://" + host(port) + "\r\n"))), 200);
  EXPECT_EQ(status_of(reply(
                port, "GET / HTTP/1.1\r\nHost: localhost:" + std::to_string(port) + "\r\nConnection: close\r\n\r\n")),
            200);
  EXPECT_EQ(status_of(reply(port, "GET / HTTP/1.0\r\nHost: " + host(port) + "\r\n\r\n")), 200);
  const std::string broken = reply(port, get(port, "/broken"));
  EXPECT_EQ(status_of(broken), 500);
  EXPECT_EQ(body_of(broken), "the file is damaged\n");
}

TEST(Server, one_connection_takes_many_requests) {
  SmallSite site;
  Served served(site);
  Client client(served.port());
  const std::string request = "GET / HTTP/1.1\r\nHost: " + host(served.port()) + "\r\n\r\n";
  client.send(request + request + request);  // pipelined requests are allowed
  const auto count = [](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(kWords, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  client.take([&](const std::string& text) { return count(text) >= 3; });
  EXPECT_EQ(count(client.got()), 3U);
  EXPECT_FALSE(client.ended());
}

TEST(Server, refuses_what_is_not_meant_for_it) {
  SmallSite site;
  Served served(site);
  const std::uint16_t port = served.port();
  const std::string end = "Connection: close\r\n\r\n", ours = "Host: " + host(port) + "\r\n";
  const auto code = [&](const std::string& request) { return status_of(reply(port, request)); };
  EXPECT_EQ(code("GET / HTTP/1.1\r\nHost: evil.example\r\n" + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\nHost: evil.example:" + std::to_string(port) + "\r\n" + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n" + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\n" + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\n" + ours + ours + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\n" + ours + "Origin: http://evil.example\r\n" + end), 403);
  EXPECT_EQ(code("GET / HTTP/1.1\r\n" + ours + "Origin: null\r\n" + end), 403);
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "PATCH", "PROPFIND", "GETT"})
    EXPECT_EQ(code(get(port, "/", "", method)), 405) << method;
  for (const char* path : {"/..", "/../../etc/passwd", "/%2e%2e/etc/passwd", "/./", "//", "/index.html", "/?", "/#",
                           "*", "/frame/0", "http://127.0.0.1/", "/live"})
    EXPECT_EQ(code(get(port, path)), 404) << path;
  EXPECT_EQ(code(get(port, "/", "Content-Length: 5\r\n") + "hello"), 413);
  EXPECT_EQ(code(get(port, "/", "Content-Length: 99999999999\r\n")), 413);
  EXPECT_EQ(code(get(port, "/", "Transfer-Encoding: chunked\r\n") + "5\r\nhello\r\n0\r\n\r\n"), 413);
  EXPECT_EQ(code(get(port, "/", "X: " + std::string(9000, 'x') + "\r\n")), 431);
  EXPECT_EQ(code(get(port, "/" + std::string(20000, 'x'))), 431);
  std::string many;
  for (int i = 0; i < 2000; ++i) many += "X" + std::to_string(i) + ": y\r\n";
  EXPECT_EQ(code(get(port, "/", many)), 431);
  EXPECT_EQ(code("this is no request\r\n\r\n"), 400);
  EXPECT_EQ(code(get(port, "/", "no colon\r\n")), 400);
  EXPECT_EQ(code(get(port, "/", "Content-Length: -1\r\n")), 400);
  EXPECT_EQ(code(get(port, "/")), 200);
}

TEST(Server, slow_requests_and_too_many_connections_end) {
  SmallSite site;
  ServerLimits limits;
  limits.request = 1s;
  limits.connections = 3;
  Served served(site, limits);
  Client slow(served.port()), idle(served.port()), other(served.port());
  slow.send("GET / HTTP/1.1\r\nHost: ");
  for (int i = 0; i < 5; ++i) {  // single bytes do not extend the time limit
    std::this_thread::sleep_for(20ms);
    slow.send("1");
  }
  Client one_too_many(served.port());
  one_too_many.send(get(served.port(), "/"));
  EXPECT_EQ(one_too_many.take_all(), "");
  EXPECT_TRUE(one_too_many.ended());
  slow.take_all();
  idle.take_all();
  EXPECT_TRUE(slow.ended() && idle.ended());
  // The server counts a connection until it has released it, a moment after the client has received the close.
  int status = 0;
  for (int k = 0; k < 100 && status != 200; ++k) {
    if (k > 0) std::this_thread::sleep_for(20ms);
    status = status_of(reply(served.port(), get(served.port(), "/")));
  }
  EXPECT_EQ(status, 200);
}

TEST(Server, listens_on_the_loopback_interface_alone_and_a_port_once) {
  SmallSite site;
  const Server server(site, 0);
  EXPECT_EQ(server.address(), "http://127.0.0.1:" + std::to_string(server.port()) + "/");
  try {
    const Server again(site, server.port());
    FAIL() << "two servers share a port";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find(std::to_string(server.port())), std::string::npos) << e.what();
  }
  std::ifstream table("/proc/net/tcp");
  std::array<char, 16> wanted{};
  std::snprintf(wanted.data(), wanted.size(), ":%04X", server.port());
  std::string line;
  int listening = 0;
  while (std::getline(table, line)) {
    std::istringstream words(line);
    std::string number, local, remote, state;
    words >> number >> local >> remote >> state;
    if (!local.ends_with(wanted.data()) || state != "0A") continue;
    ++listening;
    EXPECT_EQ(local.substr(0, 8), "0100007F");
  }
  EXPECT_EQ(listening, 1);
}

// ------------------------------------------------------------------------------------------------- fuzz

/// A request with some bytes changed, duplicated, removed or inserted.
std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % std::max<std::size_t>(1, n); };
  static const std::vector<std::string> kPieces{"\r\n",
                                                "\r\n\r\n",
                                                std::string(1, '\0'),
                                                "\xFF\xFE",
                                                ": ",
                                                "Host: x\r\n",
                                                "Content-Length: 7\r\n",
                                                "HTTP/9.9",
                                                "%00",
                                                "../",
                                                "Transfer-Encoding: chunked\r\n",
                                                "Expect: 100-continue\r\n"};
  const std::size_t changes = 1 + below(4);
  for (std::size_t k = 0; k < changes && !text.empty(); ++k) {
    const std::size_t at = below(text.size());
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(random() & 0xFFU);
        break;
      case 1:
        text.erase(at, 1 + below(8));
        break;
      case 2:
        text.insert(at, kPieces[below(kPieces.size())]);
        break;
      case 3:
        text.insert(at, text.substr(at, 1 + below(40)));
        break;
      case 4:
        text.resize(at);
        break;
      default:
        text.insert(at, std::string(below(300), static_cast<char>(random() & 0xFFU)));
    }
  }
  return text;
}

TEST(Server, lives_on_after_ten_thousand_damaged_requests) {
  constexpr int kRequests = 10000;
  SmallSite site(2);
  site.versions = 1;
  ServerLimits limits;
  limits.connections = 64;
  Served served(site, limits);
  const std::uint16_t port = served.port();
  std::mt19937 random(20240611);
  const std::vector<std::string> seeds{
      get(port, "/"), get(port, "/frame/1", "Origin: " + own_origin(port) + "\r\n", "HEAD"),
      upgrade(port, own_origin(port)),
      upgrade(port, own_origin(port)) + ws_frame("n") + ws_frame("x", 9) + ws_frame("n")};
  std::map<int, int> codes;
  for (int i = 0; i < kRequests; ++i) {
    const std::string request = mutated(seeds[static_cast<std::size_t>(i) % seeds.size()], random);
    Client client(port);
    ASSERT_TRUE(client.connected()) << i;
    client.send(request);
    client.finish();
    client.take([](const std::string& text) { return text.size() > 12; }, 2000ms);
    const int code = status_of(client.got());
    ++codes[code];
    if (code == 200) {  // content is sent only if the request names this host
      EXPECT_NE(request.find(host(port)), std::string::npos) << i;
    }
  }
  EXPECT_GT(codes[200], 0);
  EXPECT_GT(codes[400], 0);
  EXPECT_GT(codes[421], 0);
  EXPECT_GT(codes[404] + codes[405], 0);
  EXPECT_GT(codes[101], 0);
  EXPECT_EQ(status_of(reply(port, get(port, "/"))), 200);
  LiveClient viewer(port);
  EXPECT_EQ(viewer.next(2).size(), 2U);
}

}  // namespace
}  // namespace scree::io::test::serve_test
