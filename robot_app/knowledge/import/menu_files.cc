#include "robot_app/knowledge/import/menu_files.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "bt_core/base/json.h"
#include "bt_core/base/read_file.h"
#include "robot_app/knowledge/store/folded_text.h"

namespace coppice::robot::knowledge {
namespace {

using JsonKind = JsonValue::Kind;

/// What in the notes of a meal says that it is of a diet.
struct DietNotes {
  std::string diet;
  std::vector<std::string> notes;  // folded
};

std::vector<DietNotes> ReadDiets(const std::string& path, Campus& campus, SiteIds& ids,
                                 Diagnostics& diagnostics) {
  std::vector<DietNotes> diets;
  YamlFields file = YamlFields::Load(path, diagnostics);
  for (YamlFields& fields : file.Maps("diets")) {
    const LocatedText id = fields.Text("id");
    if (ids.diets.Add(id, diagnostics)) campus.diets.push_back(id.text);
    ReadNames(fields, Kind::kDiet, id.text, campus.names);
    diets.push_back({id.text, {}});
    for (const LocatedText& note : fields.Texts("notes")) {
      diets.back().notes.push_back(Folded(note.text));
    }
    fields.Finish();
  }
  file.Finish();
  return diets;
}

class Reader {
 public:
  Reader(const std::vector<DietNotes>& diets, Campus& campus, Diagnostics& diagnostics)
      : diets_(diets), campus_(campus), diagnostics_(diagnostics) {}

  void Read(const JsonValue& days, const std::string& canteen, Language language) {
    if (!Is(days, JsonKind::kArray, "a list of days")) return;
    for (const JsonValue& day : days.children) {
      if (Is(day, JsonKind::kObject, "a day: {\"date\", \"closed\", \"meals\"}")) {
        ReadDay(day, canteen, language);
      }
    }
  }

 private:
  bool Is(const JsonValue& value, JsonKind kind, const std::string& expected) {
    if (value.is(kind)) return true;
    diagnostics_.Error(value.where, "expected " + expected);
    return false;
  }

  // Null, with an error, if it is missing or something else.
  const JsonValue* Needed(const JsonValue& object, const char* key, JsonKind kind,
                          const std::string& expected) {
    const JsonValue* const value = object.Find(key);
    if (!value) diagnostics_.Error(object.where, "\"" + std::string(key) + "\" is missing");
    return value && Is(*value, kind, expected) ? value : nullptr;
  }

  void ReadDay(const JsonValue& object, const std::string& canteen, Language language) {
    const JsonValue* const date = Needed(object, "date", JsonKind::kString, "a date");
    if (!date) return;
    const std::optional<Day> day = ParseDay(date->text);
    if (!day) {
      diagnostics_.Error(date->where, "expected a date such as 2026-11-25, not " + date->text);
      return;
    }
    const JsonValue* const closed = object.Find("closed");
    MenuOfDay menu{canteen, *day, language, closed && closed->text == "true", {}};
    if (!menu.is_closed || object.Find("meals")) {
      const JsonValue* const meals = Needed(object, "meals", JsonKind::kArray, "a list of meals");
      if (!meals) return;
      for (const JsonValue& meal : meals->children) ReadMeal(meal, menu);
    }
    campus_.menus.push_back(std::move(menu));
  }

  void ReadMeal(const JsonValue& object, MenuOfDay& menu) {
    if (!Is(object, JsonKind::kObject, "a meal: {\"name\", ...}")) return;
    const JsonValue* const name = Needed(object, "name", JsonKind::kString, "a text");
    if (!name) return;
    Meal meal;
    meal.name = name->text;
    if (const JsonValue* const category = object.Find("category")) meal.category = category->text;
    if (const JsonValue* const prices = object.Find("prices")) {
      meal.price_students = ReadPrice(*prices, "students");
      meal.price_employees = ReadPrice(*prices, "employees");
      meal.price_others = ReadPrice(*prices, "others");
    }
    if (const JsonValue* const notes = object.Find("notes")) ReadNotes(*notes, meal);
    menu.meals.push_back(std::move(meal));
  }

  std::optional<double> ReadPrice(const JsonValue& prices, const char* group) {
    const JsonValue* const price = prices.Find(group);
    if (!price || price->is(JsonKind::kNull)) return std::nullopt;
    if (!Is(*price, JsonKind::kNumber, "a price in EUR")) return std::nullopt;
    return std::strtod(price->text.c_str(), nullptr);
  }

  void ReadNotes(const JsonValue& notes, Meal& meal) {
    for (const DietNotes& diet : diets_) {
      const bool fits =
          std::any_of(notes.children.begin(), notes.children.end(), [&diet](const JsonValue& note) {
            return std::find(diet.notes.begin(), diet.notes.end(), Folded(note.text)) !=
                   diet.notes.end();
          });
      if (fits) meal.diets.push_back(diet.diet);
    }
  }

  const std::vector<DietNotes>& diets_;
  Campus& campus_;
  Diagnostics& diagnostics_;
};

void ReadMenu(const std::filesystem::path& path, const std::vector<DietNotes>& diets,
              Campus& campus, SiteIds& ids, Diagnostics& diagnostics) {
  const std::filesystem::path stem = path.stem();
  const std::string extension = stem.extension();
  const auto language = LanguageOf(extension.empty() ? "" : extension.substr(1));
  if (path.extension() != ".json" || !language) {
    diagnostics.Error({path, 0, 0}, "expected a name such as canteen.en.json or canteen.de.json");
    return;
  }
  const std::string canteen = stem.stem();
  ids.places.Expect({canteen, {path, 0, 0}}, diagnostics);
  const auto text = coppice::ReadFile(path, diagnostics, kLongestJson);
  if (!text) return;
  Diagnostics of_file;
  const auto days = ParseJson(*text, path, of_file);
  if (days) Reader(diets, campus, of_file).Read(*days, canteen, *language);
  diagnostics.Append(of_file);
}

}  // namespace

void ReadMenus(const std::string& folder, Campus& campus, SiteIds& ids, Diagnostics& diagnostics) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<DietNotes> diets;
  const std::filesystem::path diets_file = std::filesystem::path(folder) / "diets.yaml";
  if (std::filesystem::exists(diets_file)) {
    diets = ReadDiets(diets_file, campus, ids, diagnostics);
  }
  for (const std::filesystem::path& path : paths) {
    if (path != diets_file) ReadMenu(path, diets, campus, ids, diagnostics);
  }
}

}  // namespace coppice::robot::knowledge
