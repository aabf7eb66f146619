#include "robot_app/deployment/run_seeds.h"

#include <atomic>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <thread>

#include "robot_app/deployment/figures/journal_file.h"
#include "robot_app/deployment/robot/robot.h"

namespace coppice::robot::deployment {
namespace {

constexpr std::size_t kMostSeeds = 10'000;

bool ReadNumber(std::string_view& text, std::uint64_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

double ProcessorSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// What a run of the seed that was broken off has left.
void RemoveRecords(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code problem;
  const std::string stem = fs::path(name).filename().string() + ".";
  for (const auto& entry : fs::directory_iterator(fs::path(name).parent_path(), problem)) {
    const std::string file = entry.path().filename().string();
    if (file.rfind(stem, 0) == 0 && entry.path().extension() == ".coppice") {
      fs::remove(entry.path(), problem);
    }
  }
}

// How far all seeds together are.
class Progress {
 public:
  Progress(std::size_t seeds, bool tells)
      : seeds_(seeds), tells_(tells), begun_(std::chrono::steady_clock::now()) {}

  void Done(std::uint64_t seed, const Journal& journal) {
    if (!tells_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    const double spent =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    const double left = spent / static_cast<double>(done_) * static_cast<double>(seeds_ - done_);
    char text[200];
    std::snprintf(text, sizeof text,
                  "%s seed %llu: %zu unplanned stops, %zu requests, %.1f km in %.1f s; %zu of %zu, "
                  "%.0f s left\n",
                  journal.controller.c_str(), static_cast<unsigned long long>(seed),
                  journal.stops.size(), journal.requests.size(), journal.distance / 1000,
                  journal.cpu_seconds, done_, seeds_, left);
    std::cerr << text;
  }

 private:
  const std::size_t seeds_;
  const bool tells_;
  const std::chrono::steady_clock::time_point begun_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

}  // namespace

Expected<std::vector<std::uint64_t>> ParseSeeds(const std::string& text) {
  std::vector<std::uint64_t> seeds;
  std::string_view left = text;
  const Problem problem{"\"" + text + "\" are no seeds, expected \"1-20\" or \"1,5,7-9\""};
  do {
    std::uint64_t first = 0;
    if (!ReadNumber(left, first)) return problem;
    std::uint64_t last = first;
    if (!left.empty() && left[0] == '-') {
      left.remove_prefix(1);
      if (!ReadNumber(left, last)) return problem;
    }
    if (last < first || last - first >= kMostSeeds - seeds.size()) return problem;
    for (std::uint64_t i = 0; i <= last - first; ++i) seeds.push_back(first + i);
    if (left.empty()) return seeds;
    if (left[0] != ',') return problem;
    left.remove_prefix(1);
  } while (true);
}

std::string NameOfSeed(const std::string& folder, std::uint64_t seed) {
  char name[32];
  std::snprintf(name, sizeof name, "/seed-%04llu", static_cast<unsigned long long>(seed));
  return folder + name;
}

Journal RunSeed(const Scenario& scenario, const Shipped& shipped, const Controller& controller,
                std::uint64_t seed, const std::string& record) {
  const double begun = ProcessorSeconds();
  World world(scenario, seed);
  world.journal.controller = controller.name;
  world.journal.seed = seed;
  world.journal.span = scenario.calendar.span();
  world.journal.duties = scenario.calendar.duties();
  {
    Robot robot(world, shipped, controller, record);
    robot.Run();
  }
  world.journal.cpu_seconds = ProcessorSeconds() - begun;
  return std::move(world.journal);
}

Outcome RunSeeds(const Scenario& scenario, const Shipped& shipped, const Controller& controller,
                 const std::vector<std::uint64_t>& seeds, const SeedOptions& options) {
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  std::vector<std::uint64_t> left;
  for (const std::uint64_t seed : seeds) {
    const std::string file = NameOfSeed(options.folder, seed) + ".json";
    if (!std::filesystem::exists(file, error)) left.push_back(seed);
  }
  Progress progress(left.size(), options.tells_progress);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  Outcome outcome;
  const auto work = [&] {
    for (std::size_t i = next++; i < left.size(); i = next++) {
      const std::string name = NameOfSeed(options.folder, left[i]);
      RemoveRecords(name);
      Journal journal = RunSeed(scenario, shipped, controller, left[i],
                                options.is_recorded ? name : std::string());
      journal.without = options.without;
      journal.times = options.times;
      const Outcome kept = SaveJournal(journal, name + ".json");
      progress.Done(left[i], journal);
      const std::lock_guard<std::mutex> lock(mutex);
      if (!kept && outcome) outcome = kept;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < options.jobs; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return outcome;
}

}  // namespace coppice::robot::deployment
