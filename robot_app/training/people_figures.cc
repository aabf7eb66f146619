#include "robot_app/training/people_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>

namespace coppice::robot::training {
namespace {

constexpr double kSamePerson = 0.5;  // m
constexpr double kFarthest = 20;     // m

std::size_t BandOf(double distance) { return distance <= 5 ? 0 : distance <= 10 ? 1 : 2; }

std::optional<Occlusion> OcclusionOf(const PersonTruth& person) {
  if (person.visible < 0.3) return std::nullopt;
  if (person.in_group) return Occlusion::kGroup;
  if (person.visible <= 0.7) return Occlusion::kHalfHidden;
  return Occlusion::kFree;
}

}  // namespace

void PeopleCount::Add(const std::vector<simulation::Vec2>& seen,
                      const std::vector<PersonTruth>& people) {
  ++figures_.scans;
  std::vector<bool> found(people.size(), false);
  for (const simulation::Vec2 at : seen) AddSeen(at, people, found);
  for (std::size_t i = 0; i < people.size(); ++i) {
    const auto occlusion = OcclusionOf(people[i]);
    const double distance = simulation::Length(people[i].position);
    if (!occlusion || distance > kFarthest) continue;
    Misses& misses = figures_.misses[BandOf(distance)][static_cast<std::size_t>(*occlusion)];
    ++misses.people;
    misses.missed += found[i] ? 0 : 1;
  }
}

void PeopleCount::AddSeen(simulation::Vec2 at, const std::vector<PersonTruth>& people,
                          std::vector<bool>& found) {
  double nearest = kSamePerson;
  std::size_t who = people.size();
  for (std::size_t i = 0; i < people.size(); ++i) {
    const double off = simulation::Length(people[i].position - at);
    if (found[i] || off >= nearest) continue;
    nearest = off;
    who = i;
  }
  if (who == people.size()) {
    ++figures_.false_people[BandOf(simulation::Length(at))];
    return;
  }
  found[who] = true;
  if (simulation::Length(at) > 5) return;
  squares_ += nearest * nearest;
  ++near_;
}

PeopleFigures PeopleCount::figures() const {
  PeopleFigures figures = figures_;
  figures.position_error = std::sqrt(squares_ / std::max(near_, 1));
  return figures;
}

double PeopleFigures::false_per_scan() const {
  const int all = std::accumulate(false_people.begin(), false_people.end(), 0);
  return scans > 0 ? static_cast<double>(all) / scans : 0;
}

std::string Table(const PeopleFigures& figures) {
  static constexpr const char* kBands[] = {"0-5 m", "5-10 m", "10-20 m"};
  std::string text =
      "| distance | in full view | half hidden | groups of three | false people a scan |\n"
      "|---|---|---|---|---|\n";
  for (std::size_t band = 0; band < figures.misses.size(); ++band) {
    text += "| " + std::string(kBands[band]);
    for (const Misses& misses : figures.misses[band]) {
      char cell[64];
      std::snprintf(cell, sizeof(cell), " | %.1f %% of %d missed", 100 * misses.share(),
                    misses.people);
      text += cell;
    }
    char cell[32];
    std::snprintf(cell, sizeof(cell), " | %.3f |\n",
                  static_cast<double>(figures.false_people[band]) / std::max(figures.scans, 1));
    text += cell;
  }
  char end[128];
  std::snprintf(end, sizeof(end), "\n%d scans, %.1f ms each; position within 5 m: %.2f m\n",
                figures.scans, 1e3 * figures.seconds / std::max(figures.scans, 1),
                figures.position_error);
  return text + end;
}

}  // namespace coppice::robot::training
