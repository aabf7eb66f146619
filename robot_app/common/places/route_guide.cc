#include "robot_app/common/places/route_guide.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coppice::robot {
namespace {

constexpr double kOnEdge = 1.0;  // a robot no farther from the line between two places [m]
constexpr double kPace = 0.5;    // to where a way begins [m/s]
constexpr char kArrow[] = "-> ";

std::size_t Index(int index) { return static_cast<std::size_t>(index); }

// "a -> b -> c": the texts between the arrows; the first may be empty.
std::vector<std::string> SplitLeg(const std::string& leg) {
  std::vector<std::string> names;
  std::size_t from = 0;
  for (std::size_t at; (at = leg.find(kArrow, from)) != std::string::npos;) {
    names.push_back(leg.substr(from, at - from));
    from = at + sizeof kArrow - 1;
  }
  names.push_back(leg.substr(from));
  for (std::string& name : names) {
    if (!name.empty() && name.back() == ' ') name.pop_back();
  }
  return names;
}

}  // namespace

bool RouteGuide::IsAt(const Pose2D& robot, int place) const {
  const Place& there = map_.places()[Index(place)];
  return there.pose && Distance(*there.pose, robot) <= there.tolerance;
}

// To the straight line between its ends [m].
double RouteGuide::DistanceTo(const Edge& edge, const Pose2D& robot) const {
  const auto& from = map_.places()[Index(edge.from)].pose;
  const auto& to = map_.places()[Index(edge.to)].pose;
  if (!from || !to) return std::numeric_limits<double>::infinity();
  const double dx = to->x - from->x, dy = to->y - from->y, square = dx * dx + dy * dy;
  const double along =
      square > 0 ? ((robot.x - from->x) * dx + (robot.y - from->y) * dy) / square : 0;
  const double part = std::clamp(along, 0.0, 1.0);
  return std::hypot(from->x + part * dx - robot.x, from->y + part * dy - robot.y);
}

// At a place: there. Else both ends of each edge that the robot is on, and the nearest place.
std::vector<RouteGuide::Entry> RouteGuide::Entries(const Pose2D& robot) const {
  std::vector<Entry> entries;
  const int nearest = map_.Nearest(robot);
  if (nearest < 0) return entries;
  const auto enter = [&](int place, int edge) {
    const double away = Distance(*map_.places()[Index(place)].pose, robot);
    entries.push_back({{place, away / kPace}, edge});
  };
  if (IsAt(robot, nearest)) return {{{nearest, 0}, -1}};
  for (std::size_t i = 0; i < map_.edges().size(); ++i) {
    const Edge& edge = map_.edges()[i];
    const bool driven = edge.kind == EdgeKind::kDrive || edge.kind == EdgeKind::kDoor;
    if (driven && DistanceTo(edge, robot) <= kOnEdge) enter(edge.to, static_cast<int>(i));
  }
  enter(nearest, -1);
  return entries;
}

std::optional<Route> RouteGuide::Find(const std::vector<Entry>& entries, int place,
                                      Time now) const {
  std::vector<RouteStart> starts;
  for (const Entry& entry : entries) {
    starts.push_back(entry.start);
    if (entry.edge >= 0) starts.back().cost += memory_.Detour(entry.edge, now);
  }
  return FindRoute(map_, starts, place, memory_.Costs(now));
}

// Of a leg whose edges end before edge `next` of the route.
Pose2D RouteGuide::GoalOf(const Route& route, std::size_t next) const {
  const int to = next == 0 ? route.start : map_.edges()[Index(route.edges[next - 1])].to;
  Pose2D goal = *map_.places()[Index(to)].pose;
  if (next == route.edges.size()) return goal;
  const auto& after = map_.places()[Index(map_.edges()[Index(route.edges[next])].to)].pose;
  if (after) goal.yaw = std::atan2(after->y - goal.y, after->x - goal.x);
  return goal;
}

Expected<std::optional<Leg>> RouteGuide::Next(const Pose2D& robot, int place, Time now) const {
  const std::vector<Entry> entries = Entries(robot);
  const auto route = Find(entries, place, now);
  if (!route) {
    return Problem{"no edges of the map lead to \"" + map_.places()[Index(place)].name + "\""};
  }
  const Entry& entry = *std::find_if(entries.begin(), entries.end(), [&](const Entry& candidate) {
    return candidate.start.place == route->start;  // on several edges: it does not matter which
  });
  const auto kind = [&](std::size_t edge) { return map_.edges()[Index(route->edges[edge])].kind; };
  const bool at_start = IsAt(robot, route->start);
  Leg leg;
  leg.to = route->start;
  std::size_t next = 0;
  if (at_start) {
    leg.name = map_.places()[Index(route->start)].name;
  } else {  // on the way to where the edges begin
    leg.name = kArrow + map_.places()[Index(route->start)].name;
    if (entry.edge >= 0) leg.kind = map_.edges()[Index(entry.edge)].kind;
  }
  const auto add = [&] {
    leg.to = map_.edges()[Index(route->edges[next])].to;
    leg.name += " " + (kArrow + map_.places()[Index(leg.to)].name);
    ++next;
  };
  if (at_start) {
    if (route->edges.empty() || kind(0) == EdgeKind::kElsewhere) return std::optional<Leg>();
    leg.kind = kind(0);
    add();
  }
  while (leg.kind == EdgeKind::kDrive && next < route->edges.size() &&
         kind(next) == EdgeKind::kDrive) {
    add();
  }
  leg.goal = GoalOf(*route, next);
  return std::optional<Leg>(leg);
}

// The edges of a leg. `whole`: the robot travelled all of them from where they begin; else the edge
// on which it was is the first one, if there is one.
std::vector<int> RouteGuide::EdgesOf(const std::string& leg, const Pose2D& robot,
                                     bool* whole) const {
  std::vector<int> edges;
  const std::vector<std::string> names = SplitLeg(leg);
  *whole = !names.front().empty();
  if (!*whole && names.size() > 1) {
    const int first = map_.Find(names[1]);
    for (std::size_t i = 0; i < map_.edges().size(); ++i) {
      const Edge& edge = map_.edges()[i];
      if (edge.to != first || DistanceTo(edge, robot) > kOnEdge) continue;
      edges.push_back(static_cast<int>(i));
      break;
    }
  }
  for (std::size_t i = *whole ? 1 : 2; i < names.size(); ++i) {
    const int edge = map_.FindEdge(map_.Find(names[i - 1]), map_.Find(names[i]));
    if (edge >= 0) edges.push_back(edge);
  }
  return edges;
}

void RouteGuide::Ended(const std::string& leg, bool travelled, const Pose2D& robot, double seconds,
                       Time now) {
  bool whole = true;
  const std::vector<int> edges = EdgesOf(leg, robot, &whole);
  if (travelled) return memory_.Travelled(edges, seconds, whole);
  if (edges.empty()) return;
  // At a place between two edges it is the second that is blocked.
  const auto before = std::min_element(edges.rbegin(), edges.rend(), [&](int a, int b) {
    return DistanceTo(map_.edges()[Index(a)], robot) < DistanceTo(map_.edges()[Index(b)], robot);
  });
  memory_.Failed(*before, now);
}

Expected<int> RouteGuide::Nearest(const Pose2D& robot, const std::string& category,
                                  Time now) const {
  const std::vector<Entry> entries = Entries(robot);
  std::vector<std::string> categories;
  int nearest = -1;
  double least = 0;
  for (std::size_t i = 0; i < map_.places().size(); ++i) {
    const Place& place = map_.places()[i];
    categories.insert(categories.end(), place.categories.begin(), place.categories.end());
    if (!place.Is(category)) continue;
    const auto route = Find(entries, static_cast<int>(i), now);
    if (!route || (nearest >= 0 && route->cost >= least)) continue;
    nearest = static_cast<int>(i);
    least = route->cost;
  }
  if (nearest >= 0) return nearest;
  const std::string hint = DidYouMean(category, categories);
  return Problem{"no place of the category \"" + category + "\" can be reached" +
                 (hint.empty() ? "" : "; " + hint)};
}

std::string RouteGuide::Words(const Pose2D& robot, int place, const std::string& language,
                              Time now) const {
  const auto route = Find(Entries(robot), place, now);
  if (!route) return "";
  for (const int index : route->edges) {
    const Edge& edge = map_.edges()[Index(index)];
    if (edge.kind == EdgeKind::kElsewhere) return WordsIn(edge.words, language);
  }
  return "";
}

}  // namespace coppice::robot
