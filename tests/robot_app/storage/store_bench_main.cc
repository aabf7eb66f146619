// coppice_store_bench                     how many messages a second are stored
// coppice_store_bench STORE SERVER [SEED]  what is lost when store and server are killed so often
// Both with a real PostgreSQL server. `./dev bench storage` runs the first.
#include <coppice_msgs/Health.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/BatteryState.h>
#include <sensor_msgs/LaserScan.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

#include "robot_app/storage/messages/message_to_json.h"
#include "robot_app/storage/server/postgres_server.h"
#include "robot_app/storage/server/shipper.h"
#include "robot_app/storage/spool/intake.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/storage/kill_story.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::storage {
namespace {

using Seconds = std::chrono::duration<double>;
using SteadyClock = std::chrono::steady_clock;

constexpr double kFeedFor = 5;  // s

struct Sample {
  std::shared_ptr<const MessageType> type;
  MessageLayout layout;
  std::string bytes;
};

template <class Message>
Sample MakeSample(const Message& message) {
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  const MessageType type{ros::message_traits::datatype(message),
                         ros::message_traits::md5sum(message),
                         ros::message_traits::definition(message)};
  return {std::make_shared<const MessageType>(type),
          ParseDefinition(type.name, type.definition).value(), bytes};
}

// What a robot sends: small and medium messages, and a scan whose ranges are left out.
std::vector<Sample> Samples() {
  coppice_msgs::Health health;
  health.entries.resize(30);
  for (auto& entry : health.entries) entry.subject = "/a_topic_or_node";
  sensor_msgs::LaserScan scan;
  scan.ranges.resize(1081, 1.5F);
  sensor_msgs::BatteryState battery;
  battery.voltage = 25.3F;
  nav_msgs::Odometry odometry;
  odometry.pose.pose.position.x = 1.0 / 3;
  return {MakeSample(battery), MakeSample(odometry), MakeSample(odometry), MakeSample(odometry),
          MakeSample(battery), MakeSample(scan),     MakeSample(odometry), MakeSample(odometry),
          MakeSample(battery), MakeSample(health)};
}

Document ToDocument(const Sample& sample) {
  const std::int64_t now = std::chrono::system_clock::now().time_since_epoch().count();
  return {0,
          5,
          now,
          now,
          "/" + sample.type->name,
          sample.type,
          *MessageToJson(sample.layout, sample.bytes, {})};
}

void MeasureDecoding(const std::vector<Sample>& samples) {
  const auto begin = SteadyClock::now();
  std::size_t bytes = 0;
  constexpr int kRounds = 5000;
  for (int i = 0; i < kRounds; ++i) {
    for (const Sample& sample : samples) bytes += ToDocument(sample).json.size();
  }
  const double messages = kRounds * static_cast<double>(samples.size());
  std::printf("decoding: %.0f messages/s, %.0f bytes of JSON each\n",
              messages / Seconds(SteadyClock::now() - begin).count(),
              static_cast<double>(bytes) / messages);
}

// So many messages a second for some seconds, through everything.
void MeasureRate(const LocalPostgres& postgres, const std::vector<Sample>& samples, double rate) {
  const TemporaryFolder folder;
  const auto spool = std::move(Spool::Open(folder.Path("spool.db"), {})).value();
  PostgresServer server(postgres.owner());
  Shipper shipper(*spool, server, {"bench", {}});
  Intake intake(*spool, {}, [&] { shipper.Wake(); });
  const auto begin = SteadyClock::now();
  const auto passed = [&] { return Seconds(SteadyClock::now() - begin).count(); };
  std::size_t count = 0;
  for (; passed() < kFeedFor; ++count) {
    intake.Put(ToDocument(samples[count % samples.size()]));
    const Seconds due(static_cast<double>(count) / rate);
    if (due.count() - passed() > 0.001) std::this_thread::sleep_until(begin + due);
  }
  const double fed = passed();
  const std::int64_t backlog = spool->Look().documents;
  Eventually([&] { return shipper.Look().sent + intake.Look().lost >= count; }, 300);
  std::printf("%8.0f offered/s: %.0f/s on the server, backlog %ld when the offer ended, %ld lost\n",
              static_cast<double>(count) / fed, static_cast<double>(count) / passed(), backlog,
              static_cast<long>(intake.Look().lost) + spool->Look().lost);
}

int Main(int argc, char** argv) {
  LocalPostgres postgres;
  if (argc > 2) {
    const KillStory story = TellKillStory(postgres, std::atoi(argv[1]), std::atoi(argv[2]),
                                          argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1);
    std::printf(
        "store killed %d times, server %d times: %ld messages accepted, %ld lost, %ld twice\n",
        story.store_kills, story.server_kills, story.accepted, story.lost, story.twice);
    return story.lost + story.twice == 0 ? 0 : 1;
  }
  const std::vector<Sample> samples = Samples();
  MeasureDecoding(samples);
  for (const double rate : {2500.0, 5000.0, 10000.0, 20000.0}) {
    MeasureRate(postgres, samples, rate);
  }
  return 0;
}

}  // namespace
}  // namespace coppice::robot::storage

int main(int argc, char** argv) { return coppice::robot::storage::Main(argc, argv); }
