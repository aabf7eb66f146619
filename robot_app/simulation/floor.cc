#include "robot_app/simulation/floor.h"

#include <yaml-cpp/yaml.h>

#include <set>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot::simulation {
namespace {

constexpr double kSteepest = 0.176;  // 10 degrees
constexpr double kFarthest = 100;    // from the origin of the map [m]; larger floors need gigabytes

// Reads typed values out of YAML nodes and reports what is wrong with them by line.
class Reader {
 public:
  Reader(const std::string& file, Diagnostics& diagnostics)
      : file_(file), diagnostics_(diagnostics) {}

  void Error(const YAML::Mark& mark, const std::string& message, const std::string& hint = {}) {
    SourceLocation where{file_, 0, 0};
    if (!mark.is_null()) {
      where.line = static_cast<std::uint32_t>(mark.line + 1);
      where.column = static_cast<std::uint32_t>(mark.column + 1);
    }
    diagnostics_.Error(where, message, hint);
  }

  // False if `node` is not a map. Unknown and repeated keys are errors.
  bool CheckMap(const YAML::Node& node, const std::string& what,
                const std::vector<std::string>& keys) {
    if (!node.IsMap()) {
      Error(node.Mark(), what + ": expected a map");
      return false;
    }
    std::set<std::string> seen;
    for (const auto& entry : node) {
      const std::string key = entry.first.Scalar();
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        Error(entry.first.Mark(), what + ": unknown key \"" + key + "\"", DidYouMean(key, keys));
      } else if (!seen.insert(key).second) {
        Error(entry.first.Mark(), what + ": key \"" + key + "\" appears twice");
      }
    }
    return true;
  }

  double Number(const YAML::Node& node, const std::string& what) {
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
      Error(node.Mark(), what + ": expected a number");
      return 0;
    }
    if (std::abs(value) <= kFarthest) return value;
    Error(node.Mark(), what + ": expected a number from -100 to 100");
    return 0;
  }

  std::vector<double> Numbers(const YAML::Node& node, std::size_t count, const std::string& what) {
    std::vector<double> values(count, 0.0);
    if (!node.IsSequence() || node.size() != count) {
      Error(node.Mark(), what + ": expected a list of " + std::to_string(count) + " numbers");
      return values;
    }
    for (std::size_t i = 0; i < count; ++i) values[i] = Number(node[i], what);
    return values;
  }

  // The members of a map `node` that describes `what`.
  YAML::Node Member(const YAML::Node& node, const std::string& what, const char* key) {
    const YAML::Node member = node[key];
    if (!member) Error(node.Mark(), what + ": \"" + key + "\" is missing");
    return member;
  }

  std::string Text(const YAML::Node& node, const std::string& what, const char* key) {
    const YAML::Node member = Member(node, what, key);
    if (!member) return {};
    if (!member.IsScalar()) Error(member.Mark(), what + ": " + key + " must be a text");
    return member.IsScalar() ? member.Scalar() : std::string();
  }

  Vec2 Point(const YAML::Node& node, const std::string& what, const char* key) {
    const YAML::Node member = Member(node, what, key);
    return member ? ToPoint(member, what + ": " + key) : Vec2{};
  }

  Vec2 ToPoint(const YAML::Node& node, const std::string& what) {
    const std::vector<double> v = Numbers(node, 2, what);
    return {v[0], v[1]};
  }

  Pose2 Pose(const YAML::Node& node, const std::string& what, const char* key) {
    const YAML::Node member = Member(node, what, key);
    if (!member) return {};
    const std::vector<double> v = Numbers(member, 3, what + ": " + key);
    return {v[0], v[1], NormalAngle(v[2])};
  }

  double Positive(const YAML::Node& node, const std::string& what, const char* key) {
    const YAML::Node member = Member(node, what, key);
    if (!member) return 1;
    const double value = Number(member, what + ": " + key);
    if (value > 0) return value;
    Error(member.Mark(), what + ": " + key + " must be greater than 0");
    return 1;
  }

  double OptionalNumber(const YAML::Node& node, const std::string& what, const char* key) {
    return node[key] ? Number(node[key], what + ": " + key) : 0;
  }

  // One of two words: true for the first one.
  bool Either(const YAML::Node& node, const std::string& what, const char* key, const char* yes,
              const char* no) {
    const std::string text = Text(node, what, key);
    if (text == yes || text == no) return text == yes;
    if (node[key]) {
      Error(node[key].Mark(),
            what + ": " + key + " must be " + yes + " or " + no + ", not \"" + text + "\"");
    }
    return true;
  }

  std::vector<Vec2> Points(const YAML::Node& node, const std::string& what) {
    std::vector<Vec2> points;
    if (!node.IsSequence() || node.size() < 2) {
      Error(node.Mark(), what + ": expected a list of at least two points [x, y]");
      return points;
    }
    for (const YAML::Node& point : node) points.push_back(ToPoint(point, what));
    return points;
  }

  // The items of the list `key` of the document; an absent list is empty.
  std::vector<YAML::Node> List(const YAML::Node& root, const char* key) {
    std::vector<YAML::Node> items;
    const YAML::Node list = root[key];
    if (!list) return items;
    if (!list.IsSequence()) {
      Error(list.Mark(), std::string(key) + ": expected a list");
      return items;
    }
    for (const YAML::Node& item : list) items.push_back(item);
    return items;
  }

 private:
  const std::string& file_;
  Diagnostics& diagnostics_;
};

FloorBox ReadBox(Reader& reader, const YAML::Node& node, const std::string& what) {
  FloorBox box;
  if (!reader.CheckMap(node, what, {"name", "at", "size", "yaw", "height", "poster"})) return box;
  box.name = reader.Text(node, what, "name");
  box.shape.center = reader.Point(node, what, "at");
  box.shape.size = reader.Point(node, what, "size");
  if (node["size"] && (box.shape.size.x <= 0 || box.shape.size.y <= 0)) {
    reader.Error(node["size"].Mark(), what + ": size must be two numbers greater than 0");
  }
  box.shape.yaw = reader.OptionalNumber(node, what, "yaw");
  box.height = reader.Positive(node, what, "height");
  if (node["poster"]) box.is_poster = reader.Either(node, what, "poster", "yes", "no");
  return box;
}

Door ReadDoor(Reader& reader, const YAML::Node& node) {
  const std::string what = "door";
  Door door;
  if (!reader.CheckMap(node, what, {"name", "kind", "hinge", "end", "swing", "state"})) return door;
  door.name = reader.Text(node, what, "name");
  door.kind = reader.Either(node, what, "kind", "hinged", "sliding") ? Door::Kind::kHinged
                                                                     : Door::Kind::kSliding;
  door.hinge = reader.Point(node, what, "hinge");
  door.end = reader.Point(node, what, "end");
  if (node["hinge"] && node["end"] && Length(door.end - door.hinge) < 0.1) {
    reader.Error(node.Mark(), what + ": hinge and end must be at least 0.1 m apart");
  }
  if (door.kind == Door::Kind::kHinged) {
    door.swings_left = reader.Either(node, what, "swing", "left", "right");
  }
  door.open = reader.Either(node, what, "state", "open", "closed");
  return door;
}

Walker ReadWalker(Reader& reader, const YAML::Node& node) {
  const std::string what = "person";
  Walker walker;
  if (!reader.CheckMap(node, what, {"name", "speed", "height", "mask", "steps_aside", "path"}))
    return walker;
  walker.name = reader.Text(node, what, "name");
  walker.speed = reader.Positive(node, what, "speed");
  if (node["height"]) walker.height = reader.Positive(node, what, "height");
  if (node["mask"]) walker.mask = reader.Either(node, what, "mask", "yes", "no");
  if (node["steps_aside"]) {
    walker.steps_aside = reader.Either(node, what, "steps_aside", "yes", "no");
  }
  const YAML::Node path = reader.Member(node, what, "path");
  if (path) walker.path = reader.Points(path, what + ": path");
  return walker;
}

FloorWaypoint ReadWaypoint(Reader& reader, const YAML::Node& node) {
  FloorWaypoint waypoint;
  if (!reader.CheckMap(node, "waypoint", {"name", "pose"})) return waypoint;
  waypoint.name = reader.Text(node, "waypoint", "name");
  waypoint.pose = reader.Pose(node, "waypoint", "pose");
  return waypoint;
}

StationLandmark ReadLandmark(Reader& reader, const YAML::Node& node) {
  const std::string what = "landmark";
  StationLandmark landmark;
  if (!reader.CheckMap(node, what, {"leg", "opening", "ahead", "height"})) return landmark;
  landmark.shape.leg = reader.Positive(node, what, "leg");
  landmark.shape.opening = reader.Positive(node, what, "opening");
  if (landmark.shape.opening >= kPi) {
    reader.Error(node["opening"].Mark(), what + ": opening must be less than pi");
  }
  landmark.shape.ahead = reader.Positive(node, what, "ahead");
  landmark.height = reader.Positive(node, what, "height");
  return landmark;
}

void ReadStation(Reader& reader, const YAML::Node& root, Floor& floor) {
  const std::string what = "charging_station";
  floor.has_station = !root["start"];
  if (!floor.has_station) {
    floor.docked = floor.staging = reader.Pose(root, "floor", "start");
    if (!root[what]) return;
    reader.Error(root["start"].Mark(), "\"start\" is for a floor without a charging_station");
  }
  const YAML::Node station = reader.Member(root, "floor", "charging_station");
  if (!station || !reader.CheckMap(station, what, {"docked", "staging", "landmark"})) return;
  floor.docked = reader.Pose(station, what, "docked");
  floor.staging = reader.Pose(station, what, "staging");
  if (station["landmark"]) floor.landmark = ReadLandmark(reader, station["landmark"]);
}

// How steep it may be is what the robot can climb, and still more than the ground of a campus.
void ReadGround(Reader& reader, const YAML::Node& node, Floor& floor) {
  floor.ground = reader.Points(node, "ground");
  for (std::size_t i = 1; i < floor.ground.size(); ++i) {
    const Vec2 step = floor.ground[i] - floor.ground[i - 1];
    if (step.x > 0 && std::abs(step.y / step.x) <= kSteepest) continue;
    reader.Error(node[i].Mark(), "ground: expected x ascending, and at most 10 degrees");
  }
}

double ReadBetween(Reader& reader, const YAML::Node& root, const char* key, double otherwise,
                   double low, double high) {
  if (!root[key]) return otherwise;
  const double value = reader.Number(root[key], key);
  if (value >= low && value <= high) return value;
  reader.Error(root[key].Mark(), std::string(key) + ": out of its range");
  return otherwise;
}

void ReadOutdoors(Reader& reader, const YAML::Node& root, Floor& floor) {
  if (root["sky"]) floor.sky = reader.Either(root, "floor", "sky", "yes", "no");
  floor.light = ReadBetween(reader, root, "light", floor.light, 0.01, 1);
  floor.resolution = ReadBetween(reader, root, "resolution", floor.resolution, 0.02, 0.5);
  if (root["ground"]) ReadGround(reader, root["ground"], floor);
}

// A name given twice could not be addressed.
template <typename Item>
void CheckNames(Reader& reader, const YAML::Node& list, const std::vector<Item>& items) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].name.empty() || names.insert(items[i].name).second) continue;
    reader.Error(list[i].Mark(), "the name \"" + items[i].name + "\" is used twice");
  }
}

Floor ReadFloor(Reader& reader, const YAML::Node& root) {
  Floor floor;
  if (!reader.CheckMap(
          root, "floor",
          {"name", "wall_height", "sky", "light", "ground", "resolution", "walls", "glass",
           "furniture", "doors", "places", "people", "charging_station", "start", "waypoints"})) {
    return floor;
  }
  floor.name = reader.Text(root, "floor", "name");
  floor.wall_height = reader.Positive(root, "floor", "wall_height");
  ReadOutdoors(reader, root, floor);
  reader.Member(root, "floor", "walls");
  for (const auto& item : reader.List(root, "walls")) {
    floor.walls.push_back(reader.Points(item, "wall"));
  }
  for (const auto& item : reader.List(root, "glass")) {
    floor.glass.push_back(reader.Points(item, "glass"));
  }
  for (const auto& item : reader.List(root, "furniture")) {
    floor.furniture.push_back(ReadBox(reader, item, "furniture"));
  }
  for (const auto& item : reader.List(root, "doors")) floor.doors.push_back(ReadDoor(reader, item));
  for (const auto& item : reader.List(root, "places")) {
    floor.places.push_back(ReadBox(reader, item, "place"));
  }
  for (const auto& item : reader.List(root, "people")) {
    floor.people.push_back(ReadWalker(reader, item));
  }
  for (const auto& item : reader.List(root, "waypoints")) {
    floor.waypoints.push_back(ReadWaypoint(reader, item));
  }
  ReadStation(reader, root, floor);
  CheckNames(reader, root["furniture"], floor.furniture);
  CheckNames(reader, root["doors"], floor.doors);
  CheckNames(reader, root["places"], floor.places);
  CheckNames(reader, root["people"], floor.people);
  CheckNames(reader, root["waypoints"], floor.waypoints);
  return floor;
}

std::optional<Floor> FloorOf(const std::optional<YAML::Node>& root, const std::string& file,
                             Diagnostics& diagnostics) {
  if (!root) return std::nullopt;
  Diagnostics found;
  Reader reader(file, found);
  std::optional<Floor> floor;
  try {
    floor = ReadFloor(reader, *root);
  } catch (const YAML::Exception& e) {
    reader.Error(e.mark, e.msg);
  }
  for (const Diagnostic& d : found.all()) diagnostics.Error(d.where, d.message, d.hint);
  return found.has_errors() ? std::nullopt : floor;
}

}  // namespace

std::optional<Floor> ParseFloor(const std::string& yaml, const std::string& file,
                                Diagnostics& diagnostics) {
  return FloorOf(ParseYaml(yaml, file, diagnostics), file, diagnostics);
}

std::optional<Floor> LoadFloor(const std::string& file, Diagnostics& diagnostics) {
  return FloorOf(LoadYaml(file, diagnostics), file, diagnostics);
}

std::optional<Segment> DoorLeaf(const Door& door, bool open) {
  if (!open) return Segment{door.hinge, door.end};
  if (door.kind == Door::Kind::kSliding) return std::nullopt;
  const double angle = door.swings_left ? kPi / 2 : -kPi / 2;
  return Segment{door.hinge, door.hinge + Rotated(door.end - door.hinge, angle)};
}

Triangle LandmarkAt(const LandmarkShape& shape, const Pose2& docked) {
  const auto at = [&](double x, double y) {
    return Compose(docked, {shape.ahead + x, y, 0}).position();
  };
  return {at(0, 0), at(shape.depth(), shape.half_width()), at(shape.depth(), -shape.half_width())};
}

std::array<Segment, 3> SidesOf(const Triangle& triangle) {
  return {Segment{triangle[0], triangle[1]}, Segment{triangle[1], triangle[2]},
          Segment{triangle[2], triangle[0]}};
}

double DistanceFromSweep(const Door& door, Vec2 point) {
  const Segment closed{door.hinge, door.end};
  if (door.kind == Door::Kind::kSliding) return Distance(point, closed);
  const Segment open = *DoorLeaf(door, true);
  const Vec2 from_hinge = point - door.hinge;
  // Between the two ends of the swing, the sweep is a quarter of a disc.
  if (Dot(from_hinge, closed.b - closed.a) >= 0 && Dot(from_hinge, open.b - open.a) >= 0) {
    return std::max(0.0, Length(from_hinge) - Length(closed.b - closed.a));
  }
  return std::min(Distance(point, closed), Distance(point, open));
}

}  // namespace coppice::robot::simulation
