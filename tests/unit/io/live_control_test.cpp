// Commands for a run: which ones the gate passes, and how the run carries them out.
#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <mutex>
#include <random>
#include <thread>

#include "io/live/channel.h"
#include "io/live/control_client.h"
#include "io/live/control_server.h"
#include "tests/unit/io/live_strip.h"

namespace scree::io::live_control_test {
namespace {

using namespace std::chrono_literals;
using namespace test;

constexpr std::int64_t kSession = 1000, kNow = 2'000'000'000;

Bytes command(ControlVerb verb, std::int64_t sequence, double value = 0.0, std::int64_t session = kSession,
              std::int64_t sender = 5) {
  return encode_command(session, {verb, value, sequence, sender});
}

// --- the gate -----------------------------------------------------------------------------------------------------

TEST(ControlGate, newer_command_passes_and_is_accepted) {
  ControlGate gate(kSession);
  const auto v = gate.take(command(ControlVerb::step, kNow, 3.0), kNow, 0.0);
  ASSERT_TRUE(v.command && v.answer);
  EXPECT_EQ(v.command->verb, ControlVerb::step);
  EXPECT_EQ(v.command->value, 3.0);
  EXPECT_EQ(v.answer->result, "accepted");
  EXPECT_EQ(gate.counts().passed, 1);
}

TEST(ControlGate, other_session_is_refused_and_counted) {
  ControlGate gate(kSession);
  const auto v = gate.take(command(ControlVerb::stop, kNow, 0.0, kSession - 1), kNow, 0.0);
  EXPECT_FALSE(v.command);
  ASSERT_TRUE(v.answer);
  EXPECT_EQ(v.answer->result, "refused");
  EXPECT_NE(v.answer->reason.find("999"), std::string::npos) << v.answer->reason;
  EXPECT_EQ(gate.counts().other_session, 1);
}

TEST(ControlGate, replayed_command_is_not_carried_out_again) {
  ControlGate gate(kSession);
  const Bytes first = command(ControlVerb::step, kNow, 1.0), second = command(ControlVerb::pause, kNow + 1);
  ASSERT_TRUE(gate.take(first, kNow, 0.0).command);
  gate.remember({{ControlVerb::step, 1.0, kNow, 5}, "done", "it was"});
  // The same command again, because its sender may have missed the answer.
  const auto again = gate.take(first, kNow, 0.1);
  EXPECT_FALSE(again.command);
  ASSERT_TRUE(again.answer);
  EXPECT_EQ(again.answer->result, "done");
  // Also after another command, and for any number of repetitions.
  ASSERT_TRUE(gate.take(second, kNow, 0.2).command);
  EXPECT_EQ(gate.take(first, kNow, 0.3).answer->result, "done");
  EXPECT_FALSE(gate.take(first, kNow, 0.301).answer) << "a flood is not answered with a flood";
  EXPECT_EQ(gate.counts().replayed, 3);
  EXPECT_EQ(gate.counts().passed, 2);
  // The command is remembered while its date is valid; afterwards its date is refused.
  EXPECT_FALSE(gate.take(first, kNow + 9'900'000, 9.9).command);
  const auto late = gate.take(first, kNow + 10'100'000, 10.1);
  EXPECT_FALSE(late.command);
  ASSERT_TRUE(late.answer);
  EXPECT_NE(late.answer->reason.find("behind"), std::string::npos) << late.answer->reason;
}

TEST(ControlGate, long_command_is_told_of_however_long_it_takes) {
  ControlGate gate(kSession);
  const Bytes steps = command(ControlVerb::step, kNow, 1e6);
  ASSERT_TRUE(gate.take(steps, kNow, 0.0).command);
  EXPECT_EQ(gate.take(steps, kNow + 600'000'000, 600.0).answer->result, "accepted");
  gate.remember({{ControlVerb::step, 1e6, kNow, 5}, "done", {}});
  EXPECT_FALSE(gate.take(steps, kNow + 601'000'000, 601.0).command);
}

TEST(ControlGate, no_forged_number_or_sender_holds_up_a_good_command) {
  ControlGate gate(kSession);
  double now = 0.0;
  std::int64_t good = 0, clock = kNow;
  for (int i = 0; i < 600; ++i) {  // 60 s
    now += 0.1, clock += 100'000;
    for (const double ahead : {59.0, 2.5, 1.99, 0.5, 0.0})  // under its own name, and under that of the good sender
      for (const std::int64_t sender : {std::int64_t{6}, std::int64_t{5}})
        if (sender != 5 || ahead > 1.0)
          (void)gate.take(
              command(ControlVerb::resume, clock + static_cast<std::int64_t>(1e6 * ahead), 0.0, kSession, sender),
              clock, now);
    if (i % 10 == 0) good += gate.take(command(ControlVerb::pause, clock), clock, now).command ? 1 : 0;
  }
  EXPECT_EQ(good, 60) << "one was asked for every second";
}

TEST(ControlGate, flood_of_one_sender_leaves_others_their_share) {
  ControlGate gate(kSession);
  for (int i = 0; i < 10000; ++i) (void)gate.take(command(ControlVerb::pause, kNow + i, 0.0, kSession, 6), kNow, 1.0);
  EXPECT_TRUE(gate.take(command(ControlVerb::stop, kNow), kNow, 1.0).command);
}

TEST(ControlGate, number_dated_ahead_does_not_shut_out_later_ones) {
  ControlGate gate(kSession);
  EXPECT_FALSE(gate.take(command(ControlVerb::stop, std::numeric_limits<std::int64_t>::max()), kNow, 0.0).command);
  EXPECT_FALSE(gate.take(command(ControlVerb::stop, kNow + 59'000'000), kNow, 0.0).command);
  EXPECT_FALSE(gate.take(command(ControlVerb::stop, std::numeric_limits<std::int64_t>::min()), kNow, 0.0).command);
  EXPECT_TRUE(gate.take(command(ControlVerb::pause, kNow), kNow, 0.0).command);
}

TEST(ControlGate, too_frequent_commands_are_refused_until_time_has_passed) {
  ControlGate gate(kSession);
  int passed = 0, answered = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto v = gate.take(command(ControlVerb::pause, kNow + i), kNow, 1.0);
    passed += v.command ? 1 : 0;
    answered += v.answer ? 1 : 0;
  }
  EXPECT_EQ(passed, ControlGate::kBurst);
  EXPECT_LE(answered, 2 * ControlGate::kBurst) << "a flood is not answered with a flood";
  EXPECT_EQ(gate.counts().too_frequent, 1000 - passed);
  EXPECT_TRUE(gate.take(command(ControlVerb::pause, kNow + 2000), kNow, 1.0 + 2.0 / ControlGate::kPerSecond).command);
}

TEST(ControlGate, malformed_commands_are_dropped_and_do_not_count_against_good_ones) {
  ControlGate gate(kSession);
  const Bytes good = command(ControlVerb::step, kNow, 2.0);
  std::int64_t sent = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    Bytes bad = good;
    bad[i] ^= 0x20U;
    EXPECT_FALSE(gate.take(bad, kNow, 0.0).command) << "byte " << i;
    EXPECT_FALSE(gate.take(std::span(good).first(i), kNow, 0.0).command) << i << " bytes";
    sent += 2;
  }
  EXPECT_EQ(gate.counts().malformed, sent);
  // Impossible lengths and values with a correct CRC.
  std::mt19937 random(7);
  for (int trial = 0; trial < 5000; ++trial) {
    Bytes bad = good;
    for (int k = 0; k < 3; ++k) bad[8 + random() % (bad.size() - 12)] = static_cast<std::uint8_t>(random());
    write_crc(bad);
    const auto v = gate.take(bad, kNow, 0.0);  // must not crash (run under asan)
    EXPECT_TRUE(!v.command || control_value_error(v.command->verb, v.command->value).empty());
  }
  EXPECT_TRUE(gate.take(command(ControlVerb::pause, kNow + 1'900'000), kNow, 100.0).command);
}

TEST(ControlGate, values_that_a_command_does_not_take_are_refused) {
  for (const double steps : {0.0, -1.0, 1.5, 2e9, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(control_value_error(ControlVerb::step, steps).empty()) << steps;
  for (const double rate : {-1.0, 1001.0, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(control_value_error(ControlVerb::rate, rate).empty()) << rate;
  EXPECT_TRUE(control_value_error(ControlVerb::rate, 0.0).empty());
  EXPECT_FALSE(control_value_error(ControlVerb::pause, 1.0).empty());
  for (const double field : {-1.0, 0.5, 10.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(control_value_error(ControlVerb::field, field).empty()) << field;
  EXPECT_TRUE(control_value_error(ControlVerb::field, 9.0).empty());
  ControlGate gate(kSession);
  EXPECT_FALSE(gate.take(command(ControlVerb::step, kNow, 1.5), kNow, 0.0).command);
  EXPECT_EQ(gate.counts().malformed, 1);
}

TEST(ControlGate, who_is_answered_whatever_session_it_names) {
  ControlGate gate(kSession);
  const auto v = gate.take(command(ControlVerb::who, kNow, 0.0, 0), kNow, 0.0);
  EXPECT_FALSE(v.command);
  ASSERT_TRUE(v.answer);
  EXPECT_EQ(v.answer->result, "done");
}

// --- the server ---------------------------------------------------------------------------------------------------

/// Steps like a driver, in its own thread, until the control requests a stop.
struct Stepper {
  std::shared_ptr<LiveBus> bus = memory_bus();
  coupling::Control no_signals;
  std::atomic<std::int64_t> steps = 0, most = std::numeric_limits<std::int64_t>::max();
  std::mutex mutex;
  std::vector<ack_v1_t> answers;      // guarded
  std::vector<std::string> happened;  // guarded: calls of the hooks
  std::int64_t number = 0;
  std::unique_ptr<ControlServer> server;
  std::thread thread;

  explicit Stepper(bool checkpoints = false) {
    ControlHooks hooks;
    hooks.session = [] { return kSession; };
    hooks.on_rate = [this](double rate) { tell("rate " + std::to_string(static_cast<int>(rate))); };
    hooks.on_field = [this](LiveField field) { tell("field " + std::string(name(field))); };
    hooks.on_pause = [this](bool paused) { tell(paused ? "paused" : "running"); };
    if (checkpoints)
      hooks.on_checkpoint = [this]() -> std::string {
        tell("checkpoint");
        if (fail) throw std::runtime_error("the disk is full");
        return "checkpoint.1";
      };
    bus->subscribe(channel_name("test", LiveKind::ack), [this](std::string_view, std::span<const std::uint8_t> bytes) {
      const std::lock_guard lock(mutex);
      answers.push_back(unseal<ack_v1_t>(bytes).value());
    });
    server = std::make_unique<ControlServer>("memq://", "test", no_signals, hooks, bus);
    server->begin(Model{}, coupling::Plan{});
    thread = std::thread([this] {
      coupling::RunStats stats;
      while (steps < most && !server->stop_requested()) {
        stats.steps = ++steps;
        server->step(0.5 * static_cast<double>(steps), stats, coupling::Ledger{});
        std::this_thread::sleep_for(200us);
      }
      coupling::FrameView last;
      last.step = steps;
      server->end({}, last);
    });
    // The memory queue stores nothing for later subscribers.
    for (int i = 0; i < 500 && !listening(); ++i) {
      bus->publish(channel_name("test", LiveKind::ctrl), command(ControlVerb::who, 1));
      std::this_thread::sleep_for(10ms);
    }
  }
  ~Stepper() {
    if (thread.joinable()) {
      ask(ControlVerb::stop);
      thread.join();
    }
  }
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;
  std::atomic<bool> fail = false;

  bool listening() {
    const std::lock_guard lock(mutex);
    return !answers.empty();
  }
  void tell(const std::string& text) {
    const std::lock_guard lock(mutex);
    happened.push_back(text);
  }
  std::int64_t ask(ControlVerb verb, double value = 0.0) {
    number = std::max(number + 1, std::chrono::duration_cast<std::chrono::microseconds>(
                                      std::chrono::system_clock::now().time_since_epoch())
                                      .count());
    bus->publish(channel_name("test", LiveKind::ctrl), command(verb, number, value));
    return number;
  }
  /// The final answer to a command.
  std::optional<ack_v1_t> end_of(std::int64_t sequence) {
    for (int i = 0; i < 500; ++i) {
      {
        const std::lock_guard lock(mutex);
        for (const ack_v1_t& a : answers)
          if (a.header.sequence == sequence && a.result != "accepted") return a;
      }
      std::this_thread::sleep_for(10ms);
    }
    return std::nullopt;
  }
};

TEST(ControlServer, paused_run_makes_no_step_and_resumed_it_goes_on) {
  Stepper run;
  const auto paused = run.end_of(run.ask(ControlVerb::pause));
  ASSERT_TRUE(paused);
  EXPECT_EQ(paused->result, "done");
  EXPECT_EQ(paused->state, "paused");
  EXPECT_EQ(paused->header.session, kSession);
  const std::int64_t at = run.steps;
  EXPECT_EQ(paused->header.step, at);
  EXPECT_EQ(paused->header.time, 0.5 * static_cast<double>(at));
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(run.steps, at);
  EXPECT_EQ(run.end_of(run.ask(ControlVerb::resume))->state, "running");
  for (int i = 0; i < 500 && run.steps < at + 5; ++i) std::this_thread::sleep_for(10ms);
  EXPECT_GE(run.steps, at + 5);
}

TEST(ControlServer, step_makes_just_so_many_steps) {
  Stepper run;
  ASSERT_TRUE(run.end_of(run.ask(ControlVerb::pause)));
  std::int64_t at = run.steps;
  for (const int steps : {1, 7, 30}) {
    const auto done = run.end_of(run.ask(ControlVerb::step, steps));
    ASSERT_TRUE(done);
    EXPECT_EQ(done->result, "done");
    EXPECT_EQ(done->state, "paused");
    EXPECT_EQ(done->header.step, at + steps);
    std::this_thread::sleep_for(20ms);
    EXPECT_EQ(run.steps, at += steps);
  }
}

TEST(ControlServer, stepping_that_another_command_ends_is_told_so) {
  Stepper run;
  ASSERT_TRUE(run.end_of(run.ask(ControlVerb::pause)));
  const std::int64_t stepping = run.ask(ControlVerb::step, 1e9);
  ASSERT_EQ(run.end_of(run.ask(ControlVerb::pause))->result, "done");
  const auto given_up = run.end_of(stepping);
  ASSERT_TRUE(given_up);
  EXPECT_EQ(given_up->result, "refused");
  EXPECT_NE(given_up->reason.find("paused"), std::string::npos) << given_up->reason;
}

TEST(ControlServer, checkpoint_is_not_available_without_its_hook) {
  Stepper run;
  EXPECT_EQ(run.end_of(run.ask(ControlVerb::checkpoint))->result, "not available");
}

TEST(ControlServer, checkpoint_that_fails_is_told_and_the_run_goes_on) {
  Stepper run(true);
  auto answer = run.end_of(run.ask(ControlVerb::checkpoint));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->result, "done");
  EXPECT_EQ(answer->reason, "checkpoint.1");
  run.fail = true;
  answer = run.end_of(run.ask(ControlVerb::checkpoint));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->result, "failed");
  EXPECT_EQ(answer->reason, "the disk is full");
  const std::int64_t at = run.steps;
  for (int i = 0; i < 500 && run.steps < at + 5; ++i) std::this_thread::sleep_for(10ms);
  EXPECT_GE(run.steps, at + 5);
}

TEST(ControlServer, stop_ends_a_paused_run_and_rate_and_field_reach_their_hooks) {
  Stepper run;
  ASSERT_TRUE(run.end_of(run.ask(ControlVerb::rate, 7.0)));
  ASSERT_TRUE(run.end_of(run.ask(ControlVerb::field, static_cast<double>(LiveField::s3))));
  ASSERT_TRUE(run.end_of(run.ask(ControlVerb::pause)));
  EXPECT_EQ(run.end_of(run.ask(ControlVerb::stop))->result, "done");
  run.thread.join();
  EXPECT_EQ(run.happened, (std::vector<std::string>{"rate 7", "field s3", "paused", "running"}));
  EXPECT_EQ(run.server->counts().passed, 4);
}

TEST(ControlServer, end_of_the_run_answers_what_is_waiting) {
  Stepper run;
  ASSERT_TRUE(run.end_of(run.ask(ControlVerb::pause)));
  run.most = run.steps + 50;
  const auto answer = run.end_of(run.ask(ControlVerb::step, 1e6));
  run.thread.join();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->result, "refused");
  EXPECT_NE(answer->reason.find("ended"), std::string::npos) << answer->reason;
  EXPECT_EQ(run.steps, run.most);
}

TEST(ControlServer, flood_of_malformed_commands_is_counted_and_the_run_still_listens) {
  Stepper run;
  const std::string channel = channel_name("test", LiveKind::ctrl);
  const Bytes good = command(ControlVerb::pause, kNow);
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    Bytes bad = good;
    bad[random() % bad.size()] ^= static_cast<std::uint8_t>(1 + random() % 255);
    bad.resize(1 + random() % bad.size());
    run.bus->publish(channel, bad);
  }
  // The queue between the library and the server keeps the newest messages: a good command is still received.
  const auto paused = run.end_of(run.ask(ControlVerb::pause));
  ASSERT_TRUE(paused);
  EXPECT_EQ(paused->result, "done");
  EXPECT_GE(run.server->counts().malformed, 1);
  EXPECT_EQ(run.server->counts().passed, 1);
}

TEST(ControlServer, urls_that_carry_no_commands_are_refused) {
  EXPECT_EQ(control_url_error("udpm://239.255.76.67:7667?ttl=0"), "");
  EXPECT_NE(control_url_error("memq://"), "");
  EXPECT_NE(control_url_error("file:///tmp/log"), "");
  EXPECT_NE(control_url_error("tcpq://127.0.0.1:7700"), "");
}

}  // namespace
}  // namespace scree::io::live_control_test
