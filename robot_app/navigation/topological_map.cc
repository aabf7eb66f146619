#include "robot_app/navigation/topological_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot::navigation {
namespace {

constexpr double kFarthest = 1e4;  // m

Place ReadPlace(YamlFields& fields) {
  Place place;
  place.name = fields.Text("name").text;
  for (const char* key : {"x", "y"}) {
    if (!fields.Has(key)) fields.Error(fields.where(), std::string("missing key \"") + key + "\"");
  }
  place.pose.x = fields.Number("x", 0, -kFarthest, kFarthest);
  place.pose.y = fields.Number("y", 0, -kFarthest, kFarthest);
  place.pose.yaw = NormalizeAngle(fields.Number("yaw", 0, -2 * M_PI, 2 * M_PI));
  place.tolerance = fields.Number("tolerance", place.tolerance, 0.01, 100);
  place.category = fields.Text("category", "patrol").text;
  fields.Finish();
  return place;
}

EdgeAction ReadAction(YamlFields& fields) {
  const std::string action = fields.Choice("action", "navigate", {"navigate", "dock", "undock"});
  if (action == "dock") return EdgeAction::kDock;
  return action == "undock" ? EdgeAction::kUndock : EdgeAction::kNavigate;
}

}  // namespace

std::optional<TopologicalMap> TopologicalMap::Load(const std::string& path,
                                                   Diagnostics& diagnostics) {
  TopologicalMap map;
  YamlFields file = YamlFields::Load(path, diagnostics);
  for (YamlFields& fields : file.Maps("waypoints")) {
    Place place = ReadPlace(fields);
    if (map.Find(place.name) >= 0) {
      fields.Error(fields.where(), "the name \"" + place.name + "\" is already taken");
    }
    map.places_.push_back(std::move(place));
  }
  if (map.places_.empty() && !diagnostics.has_errors()) {
    file.Error(file.where(), "there are no waypoints");
  }
  for (YamlFields& fields : file.Maps("edges")) {
    Edge edge;
    for (auto [key, index] : {std::pair{"from", &edge.from}, {"to", &edge.to}}) {
      const LocatedText name = fields.Text(key);
      *index = map.Find(name.text);
      if (*index < 0 && !name.text.empty()) {
        fields.Error(name.where, "there is no waypoint \"" + name.text + "\"",
                     DidYouMean(name.text, map.Names()));
      }
    }
    edge.action = ReadAction(fields);
    const bool both = fields.Choice("both_ways", "false", {"true", "false"}) == "true";
    if (both && edge.action != EdgeAction::kNavigate) {
      fields.Error(fields.where(), "only an edge with the action navigate goes both ways");
    }
    fields.Finish();
    map.edges_.push_back(edge);
    if (both) map.edges_.push_back({edge.to, edge.from, edge.action});
  }
  file.Finish();
  if (diagnostics.has_errors()) return std::nullopt;
  return map;
}

std::vector<std::string> TopologicalMap::Names() const {
  std::vector<std::string> names;
  for (const Place& place : places_) names.push_back(place.name);
  return names;
}

int TopologicalMap::Find(const std::string& name) const {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

int TopologicalMap::Nearest(const Pose2D& pose) const {
  const auto nearest =
      std::min_element(places_.begin(), places_.end(), [&](const Place& a, const Place& b) {
        return Distance(a.pose, pose) < Distance(b.pose, pose);
      });
  return static_cast<int>(nearest - places_.begin());
}

int TopologicalMap::ChooseNext(std::mt19937& random, int last, const std::string& category) const {
  std::vector<int> choices;
  int others = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].category != category) continue;
    choices.push_back(static_cast<int>(i));
    if (static_cast<int>(i) != last) ++others;
  }
  if (others > 0) choices.erase(std::remove(choices.begin(), choices.end(), last), choices.end());
  if (choices.empty()) return -1;
  // Not std::uniform_int_distribution: its sequence differs between standard libraries.
  return choices[random() % choices.size()];
}

std::optional<std::vector<int>> TopologicalMap::Route(int from, int to) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> best(places_.size(), kFar);
  std::vector<int> by(places_.size(), -1);  // the edge that leads here
  best[from] = 0;
  // Bellman-Ford: maps have a few dozen edges.
  for (std::size_t round = 0; round < places_.size(); ++round) {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Edge& edge = edges_[i];
      const double length =
          best[edge.from] + Distance(places_[edge.from].pose, places_[edge.to].pose);
      if (length >= best[edge.to]) continue;
      best[edge.to] = length;
      by[edge.to] = static_cast<int>(i);
    }
  }
  if (best[to] == kFar) return std::nullopt;
  std::vector<int> route;
  for (int at = to; at != from; at = edges_[by[at]].from) route.push_back(by[at]);
  std::reverse(route.begin(), route.end());
  return route;
}

}  // namespace coppice::robot::navigation
