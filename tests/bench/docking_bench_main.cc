// How well the charging station is recognized and reached in the simulation, beside what was
// published: `./dev bench docking [DOCKINGS [PICTURE.svg]]`.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>
#include <vector>

#include "tests/bench/docking_picture.h"
#include "tests/robot_app/docking/docking_study.h"
#include "tests/robot_app/docking/station_scans.h"

namespace coppice::robot::docking {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr int kTries = 200;

void PrintErrorsFrom(StationScans& scans, const Pose2D& landmark, double distance, int angle) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> turn(-0.8, 0.8);
  int found = 0;
  double place = 0, heading = 0;
  for (int i = 0; i < kTries; ++i) {
    const double aside = (i % 2 == 0 ? 1 : -1) * angle * kDegree;
    const Pose2D base = SeenFrom(landmark, distance, aside, turn(random));
    const auto seen = FindLandmarks(scans.From(base), {});
    if (seen.size() != 1) continue;
    const Pose2D at = Compose(base, seen[0].pose);
    ++found;
    place += std::pow(Distance(at, landmark), 2);
    heading += std::pow(NormalizeAngle(at.yaw - landmark.yaw) / kDegree, 2);
  }
  std::printf("  %3d %5.1f %4.2f", 100 * found / kTries, 1000 * std::sqrt(place / found),
              std::sqrt(heading / found));
}

void PrintErrors() {
  const Pose2D landmark = LandmarkIn(navigation::InstituteFloor());
  StationScans scans(Hall());
  std::printf("one scan: found [%%], error of the corner [mm] and of the heading [degrees], rms\n");
  std::printf("%7s", "");
  for (int angle = 0; angle <= 60; angle += 15) std::printf("   %2d degrees    ", angle);
  for (const double distance : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0}) {
    std::printf("\n%5.1f m", distance);
    for (int angle = 0; angle <= 60; angle += 15) {
      PrintErrorsFrom(scans, landmark, distance, angle);
    }
  }
  std::printf("\n\n");
}

std::vector<DockingOutcome> DockOften(int dockings) {
  std::vector<DockingOutcome> outcomes(static_cast<std::size_t>(dockings));
  std::atomic<int> next{0};
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
    threads.emplace_back([&] {
      for (int k = next++; k < dockings; k = next++) {
        outcomes[static_cast<std::size_t>(k)] = DockOnce(static_cast<std::uint64_t>(k) + 1);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  return outcomes;
}

void PrintStudy(const std::vector<DockingOutcome>& outcomes) {
  const int dockings = static_cast<int>(outcomes.size());
  int docked = 0, first = 0;
  std::vector<double> seconds;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const DockingOutcome& outcome = outcomes[i];
    docked += outcome.docked;
    first += outcome.docked && outcome.failed_attempts == 0;
    if (outcome.docked) seconds.push_back(outcome.seconds);
    if (!outcome.docked || outcome.failed_attempts > 0) {
      std::printf("docking %zu: %s, %.0f s: %s\n", i + 1, outcome.docked ? "late" : "NOT DOCKED",
                  outcome.seconds, outcome.message.c_str());
    }
  }
  std::sort(seconds.begin(), seconds.end());
  std::printf(
      "dockings: random poses, noise, worn wheels, localization, station moved by up to 0.5 m "
      "and 20 degrees, passers-by\n");
  std::printf("  current within 60 s      %d of %d (%.2f %%)   published: 27 of 28 (96.4 %%)\n",
              docked, dockings, 100.0 * docked / dockings);
  std::printf("  at the first attempt     %d of %d (%.2f %%)\n", first, dockings,
              100.0 * first / dockings);
  if (seconds.empty()) return;
  std::printf(
      "  time to lasting current  %.0f s in the median, %.0f s in 95 %% of them, %.0f s at most\n",
      seconds[seconds.size() / 2], seconds[seconds.size() * 95 / 100], seconds.back());
}

}  // namespace
}  // namespace coppice::robot::docking

int main(int argc, char** argv) {
  const int dockings = argc > 1 ? std::atoi(argv[1]) : 1000;
  if (argc > 3 || dockings < 1) {
    std::fprintf(stderr, "usage: coppice_docking_bench [DOCKINGS [PICTURE.svg]]\n");
    return 2;
  }
  namespace docking = coppice::robot::docking;
  docking::PrintErrors();
  const auto outcomes = docking::DockOften(dockings);
  docking::PrintStudy(outcomes);
  if (argc > 2 && !docking::DrawDockings(outcomes, argv[2])) {
    std::fprintf(stderr, "%s cannot be written\n", argv[2]);
    return 1;
  }
  return 0;
}
