// Live streaming in chunks: lost or damaged messages are dropped and counted, all others are kept.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <numeric>
#include <random>
#include <scree/mesh_v1_t.hpp>
#include <scree/state_v1_t.hpp>
#include <set>
#include <thread>

#include "io/live/channel.h"
#include "io/live/crc32.h"
#include "io/live/encode.h"
#include "io/live/live_publisher.h"
#include "io/live/live_reader.h"
#include "io/live/live_sink.h"
#include "io/live/quantise.h"
#include "io/live/split.h"
#include "tests/unit/io/live_strip.h"

namespace scree::io::live_damage_test {
namespace {

using namespace std::chrono_literals;
using namespace test;

TEST(LiveChunks, mesh_of_100000_points_makes_no_message_above_60_kb) {
  Strip strip(50000);
  const auto messages = short_run(strip, 0.5);
  LiveAssembly assembly;
  std::int64_t state_messages = 0;
  for (const auto& [channel, bytes] : messages) {
    EXPECT_LE(bytes.size(), 60000U) << channel;
    EXPECT_TRUE(assembly.take(channel, bytes)) << channel;
    if (channel_kind(channel) == LiveKind::state) ++state_messages;
  }
  EXPECT_EQ(state_messages, frame_chunks(0, 100002, 50000));
  ASSERT_TRUE(assembly.frame());
  // Each chunk has its own scale; displacements span 2 m at most, so the error is below half of 2 m / 65534.
  for (std::size_t i = 0; i < strip.position.size(); ++i)
    ASSERT_NEAR(assembly.frame()->position[i], strip.position[i], 1.01 / 65534.0);
}

TEST(LiveChunks, lost_chunk_loses_its_frame_only_and_the_next_one_completes) {
  Strip strip(20000);
  const std::vector<std::pair<std::string, Bytes>> messages = short_run(strip, 0.5);
  LiveAssembly assembly;
  int states = 0;
  for (const auto& [channel, bytes] : messages)
    if (channel_kind(channel) != LiveKind::state || ++states != 2) assembly.take(channel, bytes);
  EXPECT_FALSE(assembly.frame());

  LiveFrame next;
  next.mesh = assembly.mesh();
  next.header.session = assembly.info()->header.session;
  next.header.topology_id = 7;
  next.header.sequence = 1;
  next.position.assign(strip.position.size(), 0.0);
  next.scalar.assign(strip.block.size(), 0.0F);
  send_frame(next, [&](const Bytes& bytes) { assembly.take("SCREE_short_STATE", bytes); });
  ASSERT_TRUE(assembly.frame());
  EXPECT_EQ(assembly.counts().incomplete, 1);
  EXPECT_EQ(assembly.counts().frames, 1);
}

TEST(LiveChunks, mesh_lost_in_part_is_completed_by_the_next_sending) {
  Strip strip(20000);
  const auto messages = short_run(strip, 0.5);
  LiveAssembly assembly;
  int part = 0;
  for (const auto& [channel, bytes] : messages)
    if (channel_kind(channel) == LiveKind::topo && part++ % 2 == 0) assembly.take(channel, bytes);
  EXPECT_FALSE(assembly.mesh());
  part = 0;
  for (const auto& [channel, bytes] : messages)
    if (channel_kind(channel) == LiveKind::topo && part++ % 2 == 1) assembly.take(channel, bytes);
  ASSERT_TRUE(assembly.mesh());
  EXPECT_EQ(assembly.mesh()->points(), 40002U);
}

// --- damage -------------------------------------------------------------------------------------------------------

TEST(LiveDamage, message_with_any_byte_changed_is_dropped_and_counted) {
  Strip strip(10);
  for (const auto& [channel, bytes] : short_run(strip, 0.5)) {
    LiveAssembly assembly;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      Bytes bad = bytes;
      bad[i] ^= 0x10U;
      EXPECT_FALSE(assembly.take(channel, bad)) << channel << " byte " << i;
    }
    EXPECT_EQ(assembly.counts().malformed, static_cast<std::int64_t>(bytes.size()));
  }
}

TEST(LiveDamage, forged_lengths_under_a_right_crc_are_dropped) {
  std::vector<std::pair<std::string, Bytes>> meshes, messages;
  Strip strip(10);
  for (auto& message : short_run(strip, 0.5))
    (channel_kind(message.first) == LiveKind::topo ? meshes : messages).push_back(message);
  Blocks blocks(3, 2);  // with maps
  LiveFrame frame = blocks.live(std::make_shared<const LiveMesh>(LiveMesh::copy(blocks.mesh)));
  frame.header.session = unseal<info_v1_t>(messages.back().second)->header.session;
  send_mesh(frame.header, encode_mesh(*frame.mesh),
            [&](const Bytes& b) { meshes.emplace_back("SCREE_short_TOPO", b); });
  send_frame(frame, [&](const Bytes& b) { messages.emplace_back("SCREE_short_STATE", b); });
  messages.insert(messages.end(), meshes.begin(), meshes.end());

  std::mt19937 random(11);
  std::set<LiveKind> taken;
  for (const auto& message : messages)
    for (const auto& mesh : meshes) {
      const std::string& channel = message.first;
      const Bytes& bytes = message.second;
      LiveAssembly assembly;
      std::int64_t dropped = 0;
      const auto forge = [&](Bytes bad) {
        write_crc(bad);
        // Every forgery needs a known mesh; one that is taken for a later session makes the assembly drop the mesh.
        if (!assembly.mesh() || assembly.frame()) {
          assembly = LiveAssembly{};
          assembly.take(mesh.first, mesh.second);
        }
        if (assembly.take(channel, bad))  // the change hit a number; must not crash (run under asan)
          taken.insert(*channel_kind(channel));
        else
          ++dropped;
      };
      for (std::size_t i = 0; i + 4 < bytes.size(); ++i)  // every place where a length could stand
        for (const std::uint32_t value :
             {0x7FFFFFFFU, 0x40000000U, 0x20000001U, 0xFFFFFFFFU, 0x80000000U, 0U, 1U, 100000U}) {
          Bytes bad = bytes;
          for (std::size_t k = 0; k < 4; ++k) bad[i + k] = static_cast<std::uint8_t>(value >> (24U - 8U * k));
          forge(std::move(bad));
        }
      for (int trial = 0; trial < 2000; ++trial) {
        Bytes bad = bytes;
        if (trial % 2 == 0) bad.resize(4 + random() % bad.size());
        for (int k = 0; k < 3; ++k) bad[random() % bad.size()] = static_cast<std::uint8_t>(random());
        forge(std::move(bad));
      }
      EXPECT_GT(dropped, 1000) << channel;
    }
  EXPECT_TRUE(taken.contains(LiveKind::state)) << "forgeries of frames must come as far as their mesh";
}

TEST(LiveDamage, layouts_describe_the_generated_types) {
  Strip strip(3);
  const Bytes mesh = encode_mesh(LiveMesh::copy(strip.mesh));
  EXPECT_TRUE(fits(layout<mesh_v1_t>(), std::span(mesh).subspan(8)));
  EXPECT_TRUE(decode_mesh(mesh, LiveAssembly::kMaxMesh));
  std::set<LiveKind> seen;
  LiveAssembly assembly;
  for (const auto& [channel, bytes] : short_run(strip, 0.5)) {
    EXPECT_TRUE(assembly.take(channel, bytes)) << channel;
    seen.insert(*channel_kind(channel));
  }
  EXPECT_TRUE(seen.contains(LiveKind::info) && seen.contains(LiveKind::topo) && seen.contains(LiveKind::state) &&
              seen.contains(LiveKind::energy) && seen.contains(LiveKind::event));
}

TEST(LiveDamage, mesh_with_indices_out_of_range_is_refused) {
  Strip strip(3);
  LiveMesh mesh = LiveMesh::copy(strip.mesh);
  mesh.connectivity[5] = 8;  // points 0 to 7
  EXPECT_FALSE(decode_mesh(encode_mesh(mesh), LiveAssembly::kMaxMesh));
  mesh = LiveMesh::copy(strip.mesh);
  mesh.method[1] = 2;
  EXPECT_FALSE(decode_mesh(encode_mesh(mesh), LiveAssembly::kMaxMesh));
  mesh = LiveMesh::copy(strip.mesh);
  mesh.offsets[1] = -1;
  EXPECT_FALSE(decode_mesh(encode_mesh(mesh), LiveAssembly::kMaxMesh));
}

TEST(LiveDamage, later_session_replaces_an_earlier_one) {
  Strip strip(3);
  const auto first = short_run(strip, 0.5), second = short_run(strip, 0.75);
  LiveAssembly assembly;
  for (const auto& [channel, bytes] : first) assembly.take(channel, bytes);
  for (const auto& [channel, bytes] : second) assembly.take(channel, bytes);
  for (const auto& [channel, bytes] : first) EXPECT_FALSE(assembly.take(channel, bytes));
  EXPECT_EQ(assembly.frame()->header.time, 0.75);
  EXPECT_EQ(assembly.counts().other, static_cast<std::int64_t>(first.size()));
}

TEST(LiveDamage, forged_later_session_that_falls_silent_gives_way_to_the_run) {
  Strip strip(3);
  const auto messages = short_run(strip, 0.5);
  const std::int64_t now = utime_now();
  LiveAssembly assembly;
  event_v1_t forged{};
  forged.header.session = now + 1000;
  ASSERT_TRUE(assembly.take("SCREE_short_EVENT", seal(forged), now));
  const auto& [channel, bytes] = messages.front();
  EXPECT_FALSE(assembly.take(channel, bytes, now + LiveAssembly::kSilence / 2));
  EXPECT_TRUE(assembly.take(channel, bytes, now + 2 * LiveAssembly::kSilence));
  EXPECT_EQ(assembly.counts().other, 1);
}

TEST(LiveDamage, session_or_number_from_the_future_does_not_shut_out_the_run) {
  Strip strip(3);
  const auto messages = short_run(strip, 0.5);
  LiveAssembly assembly;
  for (const auto& [channel, bytes] : messages) {
    if (channel_kind(channel) != LiveKind::state) continue;
    for (const bool session : {true, false}) {
      state_v1_t forged = unseal<state_v1_t>(bytes).value();
      (session ? forged.header.session : forged.header.sequence) = std::numeric_limits<std::int64_t>::max();
      EXPECT_FALSE(assembly.take(channel, seal(forged)));
    }
  }
  EXPECT_EQ(assembly.counts().malformed, 2);
  for (const auto& [channel, bytes] : messages) EXPECT_TRUE(assembly.take(channel, bytes)) << channel;
  EXPECT_TRUE(assembly.frame());
  EXPECT_EQ(assembly.counts().other, 0);
}

}  // namespace
}  // namespace scree::io::live_damage_test
