#include "robot_app/monitoring/system/sntp.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>
#include <thread>

#include "robot_app/monitoring/system/time_server.h"

namespace coppice::robot::monitoring {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr WallTime k2026{seconds(1780000000)};

// Answers on a thread of its own until the test ends.
class ServerThread {
 public:
  explicit ServerThread(Duration clock_offset)
      : server_("127.0.0.1", 0, clock_offset), thread_([this] {
          while (!stop_) server_.Work(milliseconds(5));
        }) {}
  ~ServerThread() {
    stop_ = true;
    thread_.join();
  }
  ClockServer address() const { return {"127.0.0.1", server_.port()}; }

 private:
  TimeServer server_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

NtpPacket Reply(WallTime t2, WallTime t3) {
  NtpPacket reply;
  reply.mode = NtpPacket::kServer;
  reply.stratum = 2;
  reply.receive = ToNtp(t2);
  reply.transmit = ToNtp(t3);
  return reply;
}

TEST(Sntp, TheOffsetIsComputedFromTheFourTimeStamps) {
  // Its clock is 3 s ahead; 40 ms on the way there, 10 ms of work, 40 ms on the way back.
  const WallTime t1 = k2026, t2 = t1 + seconds(3) + milliseconds(40), t3 = t2 + milliseconds(10),
                 t4 = t1 + milliseconds(90);
  const Expected<ClockReading> reading = ReadReply(Reply(t2, t3), ToNtp(t1), ToNtp(t4));
  ASSERT_TRUE(reading);
  EXPECT_NEAR(reading->offset, 3, 1e-6);
  EXPECT_NEAR(reading->delay, 0.08, 1e-6);
}

TEST(Sntp, TimesAcrossTheEndOfTheEraIn2036AreCompared) {
  const WallTime end_of_era{seconds(4294967296 - 2208988800)};
  EXPECT_NEAR(NtpSeconds(ToNtp(end_of_era + seconds(2)), ToNtp(end_of_era - seconds(3))), 5, 1e-6);
  EXPECT_NEAR(NtpSeconds(ToNtp(end_of_era - seconds(3)), ToNtp(end_of_era + seconds(2))), -5, 1e-6);
}

TEST(Sntp, APacketSurvivesTheJourney) {
  NtpPacket packet = Reply(k2026, k2026 + milliseconds(1));
  packet.origin = 0x0123456789abcdef;
  packet.leap = 1;
  const NtpPacket::Bytes bytes = packet.Encode();
  EXPECT_EQ(bytes[0], 0x64);  // leap 1, version 4, mode 4
  const auto read = NtpPacket::Decode(bytes.data(), bytes.size());
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->leap, 1);
  EXPECT_EQ(read->mode, NtpPacket::kServer);
  EXPECT_EQ(read->stratum, 2);
  EXPECT_EQ(read->origin, packet.origin);
  EXPECT_EQ(read->receive, packet.receive);
  EXPECT_EQ(read->transmit, packet.transmit);
  EXPECT_FALSE(NtpPacket::Decode(bytes.data(), bytes.size() - 1).has_value());
}

TEST(Sntp, AServerThatKnowsNoTimeIsNotBelieved) {
  NtpPacket reply = Reply(k2026, k2026);
  reply.leap = NtpPacket::kNotSynchronized;
  EXPECT_EQ(ReadReply(reply, 0, 0).problem(), "the time server is not synchronized itself");
  reply = Reply(k2026, k2026);
  reply.stratum = 0;
  EXPECT_EQ(ReadReply(reply, 0, 0).problem(), "the time server refuses to answer");
}

TEST(Sntp, AsksServersWhoseClocksAreOff) {
  const ServerThread right{Duration::zero()}, ahead{seconds(3)}, behind{-milliseconds(250)};
  const auto readings =
      QueryClocks({right.address(), ahead.address(), behind.address()}, seconds(10));
  ASSERT_EQ(readings.size(), 3u);
  for (const auto& reading : readings) ASSERT_TRUE(reading) << reading.problem();
  EXPECT_NEAR(readings[0]->offset, 0, 0.1);
  EXPECT_NEAR(readings[1]->offset, 3, 0.1);
  EXPECT_NEAR(readings[2]->offset, -0.25, 0.1);
  EXPECT_LT(readings[1]->delay, 1);
}

TEST(Sntp, AServerThatDoesNotAnswerHoldsUpNobodyElse) {
  const Socket mute = ListenUdp("127.0.0.1", 0).value();
  const ServerThread ahead{seconds(3)};
  const auto readings = QueryClocks(
      {{"127.0.0.1", PortOf(mute)}, ahead.address(), {"no such address", 123}}, milliseconds(300));
  EXPECT_FALSE(readings[0]);
  EXPECT_EQ(readings[0].problem(), "no answer");
  EXPECT_NEAR(readings[1]->offset, 3, 0.1);
  EXPECT_FALSE(readings[2]);
  EXPECT_NE(readings[2].problem(), "");
}

TEST(Sntp, APortWhereNobodyListensIsAnErrorAtOnce) {
  int port = 0;
  { port = PortOf(ListenUdp("127.0.0.1", 0).value()); }
  const auto readings = QueryClocks({{"127.0.0.1", port}}, seconds(60));
  EXPECT_EQ(readings[0].problem(), "Connection refused");
}

}  // namespace
}  // namespace coppice::robot::monitoring
