// Decoding of LCM datagrams from untrusted senders.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "io/live/udp_receiver.h"

namespace scree::io::live_udp_test {
namespace {

Bytes datagram(std::string_view magic, std::string_view rest) {
  Bytes bytes(magic.begin(), magic.end());
  bytes.insert(bytes.end(), {0, 0, 0, 7});
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  return bytes;
}

using Kind = LcmDatagram::Kind;
using namespace std::string_view_literals;

TEST(LiveDatagram, whole_message_has_its_channel_and_data) {
  const Bytes bytes = datagram("LC02", "SCREE_x_INFO\0abc"sv);
  const LcmDatagram d = decode_datagram(bytes);
  EXPECT_EQ(d.kind, Kind::message);
  EXPECT_EQ(d.channel, "SCREE_x_INFO");
  EXPECT_EQ(std::string(d.data.begin(), d.data.end()), "abc");
}

TEST(LiveDatagram, message_without_data_is_a_message) {
  const Bytes bytes = datagram("LC02", "c\0"sv);
  const LcmDatagram d = decode_datagram(bytes);
  EXPECT_EQ(d.kind, Kind::message);
  EXPECT_TRUE(d.data.empty());
}

TEST(LiveDatagram, channel_may_have_63_characters_and_not_64) {
  const std::string longest(63, 'c'), too_long(64, 'c');
  EXPECT_EQ(decode_datagram(datagram("LC02", longest + '\0')).kind, Kind::message);
  EXPECT_EQ(decode_datagram(datagram("LC02", too_long + '\0')).kind, Kind::garbage);
}

TEST(LiveDatagram, channel_without_an_end_and_foreign_magic_are_garbage) {
  EXPECT_EQ(decode_datagram(datagram("LC02", "SCREE_x_INFO")).kind, Kind::garbage);
  EXPECT_EQ(decode_datagram(datagram("LC02", "")).kind, Kind::garbage);
  EXPECT_EQ(decode_datagram(datagram("LC04", "c\0data"sv)).kind, Kind::garbage);
  EXPECT_EQ(decode_datagram({}).kind, Kind::garbage);
}

TEST(LiveDatagram, fragments_are_told_apart_and_only_the_first_names_a_channel) {
  const auto fragment = [](std::uint8_t number, std::string_view rest) {
    Bytes bytes = datagram("LC03", "\x7f\xff\xff\xff\x80\0\0\0\0"sv);  // forged: a huge size, an offset beyond it
    bytes.insert(bytes.end(), {number, 0, 2});
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return bytes;
  };
  const Bytes first = fragment(0, "SCREE_x_INFO\0abc"sv), second = fragment(1, "SCREE_x_INFO\0abc"sv);
  EXPECT_EQ(decode_datagram(first).kind, Kind::fragment);
  EXPECT_EQ(decode_datagram(first).channel, "SCREE_x_INFO");
  EXPECT_EQ(decode_datagram(second).kind, Kind::fragment);
  EXPECT_EQ(decode_datagram(second).channel, "");
  EXPECT_EQ(decode_datagram(std::span(first).first(19)).kind, Kind::garbage);
}

TEST(LiveDatagram, random_bytes_stay_inside_the_datagram) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20000; ++trial) {
    Bytes bytes = datagram(trial % 2 == 0 ? "LC02" : "LC03", "");
    bytes.resize(bytes.size() + random() % 90);
    for (std::size_t i = 8; i < bytes.size(); ++i)
      bytes[i] = static_cast<std::uint8_t>(random() % 3 == 0 ? 0 : random());
    bytes.resize(random() % (bytes.size() + 1));
    const LcmDatagram d = decode_datagram(bytes);
    const auto* const end = bytes.data() + bytes.size();
    EXPECT_LE(d.channel.size(), 63U);
    EXPECT_TRUE(d.kind != Kind::message || d.data.data() + d.data.size() == end);
    // Reads every byte once, so that the address sanitizer reports any byte out of bounds.
    EXPECT_GE(std::accumulate(d.data.begin(), d.data.end(), 0UL) + d.channel.size(), 0UL);
  }
}

}  // namespace
}  // namespace scree::io::live_udp_test
