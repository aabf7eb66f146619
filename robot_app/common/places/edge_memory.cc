#include "robot_app/common/places/edge_memory.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "robot_app/common/places/route.h"
#include "robot_app/common/yaml_fields.h"

namespace coppice::robot {
namespace {

constexpr Duration kBlockedFor = std::chrono::hours(24);
constexpr double kDetour = 3600;  // s
constexpr int kRemembered = 20;   // trips in the mean
constexpr double kMostSeconds = 1e6;
constexpr int kMostTrips = 1'000'000'000;

void Learn(EdgeRecord& record, double seconds) {
  record.trips = std::min(record.trips + 1, kMostTrips);
  record.seconds += (seconds - record.seconds) / std::min(record.trips, kRemembered);
}

}  // namespace

EdgeMemory::EdgeMemory(const TopologicalMap& map)
    : expected_(ExpectedCosts(map)), records_(map.edges().size()) {
  for (const Edge& edge : map.edges()) {
    names_.push_back(map.NameOf(edge));
    opposite_.push_back(map.FindEdge(edge.to, edge.from));
  }
}

void EdgeMemory::Travelled(const std::vector<int>& edges, double seconds, bool whole) {
  double expected = 0;
  for (const int edge : edges) expected += expected_[static_cast<std::size_t>(edge)];
  for (const int edge : edges) {
    EdgeRecord& record = records_[static_cast<std::size_t>(edge)];
    record.blocked_until = Time{};
    const int back = opposite_[static_cast<std::size_t>(edge)];
    if (back >= 0) records_[static_cast<std::size_t>(back)].blocked_until = Time{};
    if (!whole || expected <= 0) continue;
    Learn(record, seconds * expected_[static_cast<std::size_t>(edge)] / expected);
  }
}

void EdgeMemory::Failed(int edge, Time now) {
  EdgeRecord& record = records_[static_cast<std::size_t>(edge)];
  record.failures = std::min(record.failures + 1, kMostTrips);
  record.blocked_until = now + kBlockedFor;
  const int back = opposite_[static_cast<std::size_t>(edge)];
  if (back >= 0) records_[static_cast<std::size_t>(back)].blocked_until = now + kBlockedFor;
}

double EdgeMemory::Detour(int edge, Time now) const {
  return now < records_[static_cast<std::size_t>(edge)].blocked_until ? kDetour : 0;
}

std::vector<double> EdgeMemory::Costs(Time now) const {
  std::vector<double> costs;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const EdgeRecord& record = records_[i];
    costs.push_back((record.trips > 0 ? record.seconds : expected_[i]) +
                    Detour(static_cast<int>(i), now));
  }
  return costs;
}

std::string EdgeMemory::ToText() const {
  std::string text =
      "# What the robot has learnt of its ways: seconds of a trip, and until when an edge "
      "is blocked [s].\nedges:\n";
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const EdgeRecord& record = records_[i];
    if (record.trips == 0 && record.failures == 0 && record.blocked_until == Time{}) continue;
    char line[160];
    std::snprintf(line, sizeof line,
                  "trips: %d, failures: %d, seconds: %.3f, blocked_until: %.3f}\n", record.trips,
                  record.failures, record.seconds,
                  std::chrono::duration<double>(record.blocked_until.time_since_epoch()).count());
    text += "  - {edge: \"" + names_[i] + "\", " + line;
  }
  return text;
}

void EdgeMemory::Read(const std::string& path, Time now, Diagnostics& diagnostics) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return;
  YamlFields file = YamlFields::Load(path, diagnostics);
  for (YamlFields& fields : file.Maps("edges")) {
    const std::string name = fields.Text("edge").text;
    EdgeRecord record;
    record.trips = fields.Integer("trips", 0, 0, kMostTrips);
    record.failures = fields.Integer("failures", 0, 0, kMostTrips);
    record.seconds = fields.Number("seconds", 0, 0, kMostSeconds);
    record.blocked_until = Time{} + fields.Seconds("blocked_until", 0, 0, 4e9);
    fields.Finish();
    if (record.blocked_until > now + kBlockedFor) record.blocked_until = Time{};
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) {
      records_[static_cast<std::size_t>(found - names_.begin())] = record;
    }
  }
  file.Finish();
}

}  // namespace coppice::robot
