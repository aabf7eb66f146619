#include "tests/robot_app/storage/kill_story.h"

#include <fstream>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <thread>

#include "robot_app/common/child_process.h"
#include "tests/robot_app/eventually.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::storage {
namespace {

constexpr std::int64_t kALife = 1'000'000;  // numbers of one life of the feeder
constexpr int kLong = 1'000'000;            // more than it can feed before it is killed
constexpr double kLongestLife = 0.2;        // s

class Story {
 public:
  Story(LocalPostgres& postgres, unsigned seed) : postgres_(postgres), chance_(seed) {}

  KillStory Tell(int store_kills, int server_kills) {
    Begin(kLong);
    while (story_.store_kills < store_kills || story_.server_kills < server_kills) {
      LetPass();
      const bool server_is_due =
          story_.server_kills * std::max(store_kills, 1) < story_.store_kills * server_kills;
      if (server_is_due || story_.store_kills >= store_kills) {
        KillServer();
      } else {
        KillStore();
      }
    }
    End(*feeder_);
    Begin(100);
    if (!Eventually([this] { return !feeder_->IsRunning(); }, 180) || feeder_->exit_status() != 0) {
      throw std::runtime_error("the store does not finish: " + ReadFile(folder_.Path("log")));
    }
    Count();
    return story_;
  }

 private:
  // Not waiting for anything: the moment of a murder is by chance.
  void LetPass() {
    std::this_thread::sleep_for(std::chrono::duration<double>(
        std::uniform_real_distribution<double>(0, kLongestLife)(chance_)));
  }

  void Begin(int count) {
    feeder_.emplace(
        std::vector<std::string>{BinaryFolder() + "/tests/bin/store_feeder", folder_.path(),
                                 postgres_.owner().host, std::to_string(postgres_.owner().port),
                                 std::to_string(lives_++ * kALife), std::to_string(count)},
        folder_.Path("log"));
  }

  static void End(ChildProcess& process) {
    kill(process.pid(), SIGKILL);
    Eventually([&] { return !process.IsRunning(); });
  }

  void KillStore() {
    End(*feeder_);
    ++story_.store_kills;
    Begin(kLong);
  }

  void KillServer() {
    postgres_.Kill();
    ++story_.server_kills;
    LetPass();
    postgres_.Start();
  }

  void Count() {
    std::map<std::int64_t, int> found;
    for (const std::string& id : postgres_.Ask("SELECT document->>'id' FROM coppice.messages")) {
      ++found[std::stoll(id)];
    }
    for (const auto& [id, times] : found) story_.twice += times > 1 ? 1 : 0;
    std::ifstream accepted(folder_.Path("accepted"));
    for (std::int64_t id = 0; accepted >> id; ++story_.accepted) {
      story_.lost += found.count(id) == 0 ? 1 : 0;
    }
  }

  LocalPostgres& postgres_;
  std::mt19937 chance_;
  const TemporaryFolder folder_;
  std::optional<ChildProcess> feeder_;
  std::int64_t lives_ = 0;
  KillStory story_;
};

}  // namespace

KillStory TellKillStory(LocalPostgres& postgres, int store_kills, int server_kills, unsigned seed) {
  return Story(postgres, seed).Tell(store_kills, server_kills);
}

}  // namespace coppice::robot::storage
