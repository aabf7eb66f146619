#include "robot_app/knowledge/answers/answer_texts.h"

#include <algorithm>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot::knowledge {
namespace {

struct Key {
  const char* name;
  std::vector<std::string> values;  // that are filled in
};

const std::vector<Key>& Keys() {
  static const std::vector<Key> keys = {
      {"where_floor", {"floor", "building"}},
      {"where_building", {"building"}},
      {"place_is", {"place", "where"}},
      {"can_guide", {}},
      {"nearest_is", {"place", "where"}},
      {"none_of_category", {"category"}},
      {"places_are", {"category", "count", "places"}},
      {"office_is", {"person", "place", "where"}},
      {"no_office", {"person"}},
      {"phone_and_email", {"person", "phone", "email"}},
      {"phone", {"person", "phone"}},
      {"email", {"person", "email"}},
      {"no_contact", {"person"}},
      {"occupants", {"place", "people"}},
      {"no_occupants", {"place"}},
      {"follow_me", {"place"}},
      {"cannot_guide", {"place", "where"}},
      {"menu", {"canteen", "day", "meals"}},
      {"menu_of_diet", {"canteen", "day", "diet", "meals"}},
      {"menu_closed", {"canteen", "day"}},
      {"menu_without", {"canteen", "day", "diet"}},
      {"no_menu", {"day"}},
      {"departure", {"line", "headsign", "time", "place"}},
      {"departure_later", {"line", "headsign", "day", "time", "place"}},
      {"no_departures", {}},
      {"open", {"place", "day", "times"}},
      {"closed", {"place", "day"}},
      {"no_hours", {"place"}},
      {"from_to", {"from", "to"}},
      {"all_day", {}},
      {"did_you_mean_1", {"first"}},
      {"did_you_mean_2", {"first", "second"}},
      {"did_you_mean_3", {"first", "second", "third"}},
      {"asked_1", {"first"}},
      {"asked_2", {"first", "second"}},
      {"asks_find_place", {"about"}},
      {"asks_nearest_place", {"about"}},
      {"asks_list_places", {"about"}},
      {"asks_find_person", {"about"}},
      {"asks_contact", {"about"}},
      {"asks_occupants", {"about"}},
      {"asks_guide", {"about"}},
      {"asks_menu", {}},
      {"asks_departures", {}},
      {"asks_opening_hours", {"about"}},
      {"asks_help", {}},
      {"asks_line", {"line"}},
      {"which_place", {}},
      {"which_person", {}},
      {"which_category", {}},
      {"not_heard", {}},
      {"unknown", {}},
      {"unknown_words", {"words"}},
      {"not_now", {}},
      {"help", {}},
      {"nothing_to_repeat", {}},
      {"cancelled", {}},
      {"nothing_asked", {}},
      {"language", {}},
      {"and", {}},
      {"day_today", {}},
      {"day_tomorrow", {}},
      {"day_after_tomorrow", {}},
      {"day_on", {"day"}},
      {"date", {"weekday", "day", "month"}},
      {"floor_basement", {}},
      {"floor_0", {}},
      {"floor_1", {}},
      {"floor_2", {}},
      {"floor_3", {}},
      {"floor_other", {"number"}}};
  return keys;
}

constexpr const char* kWeekdays[] = {"monday", "tuesday",  "wednesday", "thursday",
                                     "friday", "saturday", "sunday"};
constexpr int kMonths = 12;

std::vector<Key> AllKeys() {
  std::vector<Key> keys = Keys();
  for (const char* weekday : kWeekdays) keys.push_back({weekday, {}});
  for (const char* button :
       {"places", "nearby", "people", "contact", "guide", "menu", "departures", "hours", "talk",
        "help", "repeat", "back", "yes", "no", "language", "english", "german"}) {
    keys.push_back({button, {}});
  }
  return keys;
}

// Every "{value}" must be one that is filled in.
void CheckValues(YamlFields& file, const LocatedText& text, const Key& key) {
  for (std::size_t at = text.text.find('{'); at != std::string::npos;
       at = text.text.find('{', at + 1)) {
    const std::size_t end = text.text.find('}', at);
    const std::string value = text.text.substr(at + 1, end - at - 1);
    if (std::find(key.values.begin(), key.values.end(), value) != key.values.end()) continue;
    file.Error(text.where, "\"" + std::string(key.name) + "\": nobody fills in {" + value + "}",
               DidYouMean(value, key.values));
  }
}

void Replace(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

AnswerTexts AnswerTexts::Load(const std::string& folder, Language language,
                              Diagnostics& diagnostics) {
  AnswerTexts texts;
  YamlFields file = YamlFields::Load(folder + "/answers." + Code(language) + ".yaml", diagnostics);
  YamlFields buttons = file.Map("buttons"), months = file.Map("months");
  const std::size_t count = Keys().size() + std::size(kWeekdays);
  const std::vector<Key> keys = AllKeys();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool is_button = i >= count;
    const std::string name = keys[i].name;
    const LocatedText text = (is_button ? buttons : file).Text(name);
    CheckValues(file, text, keys[i]);
    texts.texts_[(is_button ? "button_" : "") + name] = text.text;
  }
  for (int month = 1; month <= kMonths; ++month) {
    const std::string number = std::to_string(month);
    texts.texts_["month_" + number] = months.Text(number).text;
  }
  months.Finish();
  buttons.Finish();
  file.Finish();
  return texts;
}

std::string AnswerTexts::Fill(const std::string& key, const Values& values) const {
  return Capitalized(Part(key, values));
}

std::string AnswerTexts::Part(const std::string& key, const Values& values) const {
  std::string text = texts_.at(key);
  for (const auto& [name, value] : values) Replace(text, "{" + name + "}", value);
  return text;
}

std::string AnswerTexts::List(const std::vector<std::string>& items) const {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 == items.size() ? " " + Word("and") + " " : ", ";
    text += items[i];
  }
  return text;
}

std::string AnswerTexts::Floor(int floor) const {
  if (floor < 0) return Word("floor_basement");
  if (floor <= 3) return Word("floor_" + std::to_string(floor));
  return Part("floor_other", {{"number", std::to_string(floor)}});
}

std::string AnswerTexts::Date(Day day) const {
  const CalendarDate date = DateOf(day);
  return Part("date", {{"weekday", Word(kWeekdays[WeekdayOf(day)])},
                       {"day", std::to_string(date.day)},
                       {"month", Word("month_" + std::to_string(date.month))}});
}

std::string AnswerTexts::DayName(Day day, Day today) const {
  if (day == today) return Word("day_today");
  if (day == today + 1) return Word("day_tomorrow");
  if (day == today + 2) return Word("day_after_tomorrow");
  const bool is_near = today < day && day < today + 7;
  return Part("day_on", {{"day", is_near ? Word(kWeekdays[WeekdayOf(day)]) : Date(day)}});
}

std::string Capitalized(std::string text) {
  if (text.empty()) return text;
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (text[0] >= 'a' && text[0] <= 'z') {
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  } else if (text.size() > 1 && byte(0) == 0xC3 && byte(1) >= 0xA0 && byte(1) != 0xB7) {
    text[1] = static_cast<char>(byte(1) - 0x20);  // U+00E0 to U+00FE
  }
  return text;
}

}  // namespace coppice::robot::knowledge
