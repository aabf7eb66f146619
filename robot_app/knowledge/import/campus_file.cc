#include <algorithm>

#include "robot_app/common/places/topological_map.h"
#include "robot_app/knowledge/import/site_files.h"
#include "robot_app/knowledge/store/opening_hours.h"

namespace coppice::robot::knowledge {
namespace {

// Categories of the robot's own: nobody asks for them.
const std::vector<std::string> kOfTheRobot = {"patrol", "station", "approach", "corridor"};

class Reader {
 public:
  Reader(const std::string& path, Campus& campus, SiteIds& ids, Diagnostics& diagnostics)
      : campus_(campus),
        ids_(ids),
        diagnostics_(diagnostics),
        file_(YamlFields::Load(path, diagnostics)) {}

  void Read(const TopologicalMap& map, const std::string& map_path) {
    for (YamlFields& fields : file_.Maps("buildings")) ReadBuilding(fields);
    for (YamlFields& fields : file_.Maps("categories")) ReadCategory(fields);
    for (const robot::Place& place : map.places()) AddPlace(place, map_path);
    for (const Edge& edge : map.edges()) AddWay(map, edge);
    for (const auto& [place, node] : file_.Pairs("places")) {
      YamlFields fields = file_.MapOf(node);
      ReadDetails(place, fields);
    }
    YamlFields site = file_.Map("site");
    ReadSite(site);
    for (Place& place : campus_.places) {
      if (place.position.building.empty()) place.position.building = here_;
    }
    file_.Finish();
  }

 private:
  void ReadSite(YamlFields& fields) {
    const LocatedText zone = fields.Text("time_zone");
    const auto time = SiteTime::Find(zone.text);
    if (!time && !zone.text.empty()) fields.Error(zone.where, time.problem());
    campus_.site.time_zone = zone.text;
    const LocatedText home = fields.Text("home");
    ids_.places.Expect(home, diagnostics_);
    campus_.site.home = home.text;
    const LocatedText building = fields.Text("building");
    buildings_.Expect(building, diagnostics_);
    here_ = building.text;
    for (const LocatedText& text : fields.Texts("holidays")) {
      const auto day = ParseDay(text.text);
      if (day) campus_.site.holidays.push_back(*day);
      if (!day) fields.Error(text.where, "expected a day such as 2026-12-25, not " + text.text);
    }
    fields.Finish();
  }

  void ReadBuilding(YamlFields& fields) {
    const LocatedText id = fields.Text("id");
    const ByLanguage<std::string> name = ReadTexts(fields, "name");
    if (buildings_.Add(id, diagnostics_)) campus_.buildings.push_back({id.text, name});
    fields.Finish();
  }

  void ReadCategory(YamlFields& fields) {
    const LocatedText id = fields.Text("id");
    if (categories_.Add(id, diagnostics_)) campus_.categories.push_back(id.text);
    ReadNames(fields, Kind::kCategory, id.text, campus_.names);
    fields.Finish();
  }

  // Places that nobody calls anything are the robot's own.
  void AddPlace(const robot::Place& place, const std::string& map_path) {
    if (place.called.empty()) return;
    ids_.places.Add({place.name, {map_path, 0, 0}}, diagnostics_);
    Place known;
    known.id = place.name;
    if (place.pose) known.position.at = Point{place.pose->x, place.pose->y};
    campus_.places.push_back(known);
    for (const std::string& category : place.categories) AddToCategory(place, category, map_path);
    for (const Language language : kLanguages) AddNames(place, language);
  }

  void AddToCategory(const robot::Place& place, const std::string& category,
                     const std::string& map_path) {
    if (categories_.Has(category)) {
      campus_.place_categories.push_back({place.name, category});
    } else if (std::find(kOfTheRobot.begin(), kOfTheRobot.end(), category) == kOfTheRobot.end()) {
      diagnostics_.Warning({map_path, 0, 0}, "\"" + place.name + "\": nobody can ask for the " +
                                                 "category \"" + category +
                                                 "\", which campus.yaml does not name");
    }
  }

  void AddNames(const robot::Place& place, Language language) {
    bool is_main = true;
    for (const Wording& wording : place.called) {
      if (wording.language != Code(language)) continue;
      campus_.names.push_back({Kind::kPlace, place.name, language, wording.text, is_main});
      is_main = false;
    }
    if (is_main) {
      campus_.names.push_back(
          {Kind::kPlace, place.name, language, place.Spoken(Code(language)), true});
    }
  }

  // What people are told of a way that the robot cannot go.
  void AddWay(const TopologicalMap& map, const Edge& edge) {
    if (edge.kind != EdgeKind::kElsewhere) return;
    Place* const place = Find(map.places()[static_cast<std::size_t>(edge.to)].name);
    if (!place) return;
    for (const Language language : kLanguages) {
      In(language, place->way) = WordsIn(edge.words, Code(language));
    }
  }

  Place* Find(const std::string& id) {
    const auto found = std::find_if(campus_.places.begin(), campus_.places.end(),
                                    [&id](const Place& place) { return place.id == id; });
    return found == campus_.places.end() ? nullptr : &*found;
  }

  void ReadDetails(const LocatedText& id, YamlFields& fields) {
    ids_.places.Expect(id, diagnostics_);
    Place ignored;
    Place* const found = Find(id.text);
    Place& place = found ? *found : ignored;
    const LocatedText building = fields.Text("building", "");
    if (!building.text.empty()) buildings_.Expect(building, diagnostics_);
    place.position.building = building.text;
    place.position.floor = fields.Integer("floor", 0, -10, 200);
    place.hours = ReadHours(fields);
    for (const LocatedText& stop : fields.Texts("stops")) ids_.stops.push_back({stop, place.id});
    fields.Finish();
  }

  std::string ReadHours(YamlFields& fields) {
    const LocatedText hours = fields.Text("hours", "");
    if (hours.text.empty()) return {};
    const auto parsed = OpeningHours::Parse(hours.text);
    if (!parsed) fields.Error(hours.where, parsed.problem());
    return hours.text;
  }

  Campus& campus_;
  SiteIds& ids_;
  Diagnostics& diagnostics_;
  YamlFields file_;
  std::string here_;  // the building of the places that say nothing else
  Ids buildings_{"building"}, categories_{"category"};
};

}  // namespace

void ReadPlaces(const std::string& folder, Campus& campus, SiteIds& ids, Diagnostics& diagnostics) {
  const std::string map_path = folder + "/places.yaml";
  const std::optional<TopologicalMap> map = TopologicalMap::Load(map_path, diagnostics);
  Diagnostics of_file;
  Reader reader(folder + "/campus.yaml", campus, ids, of_file);
  if (map && !of_file.has_errors()) reader.Read(*map, map_path);
  diagnostics.Append(of_file);
}

}  // namespace coppice::robot::knowledge
