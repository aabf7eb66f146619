#include "robot_app/knowledge/understanding/intent_table.h"

#include <algorithm>
#include <map>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot::knowledge {
namespace {

constexpr std::array<const char*, kIntents> kWords = {
    "find_place", "nearest_place", "list_places", "find_person", "contact",
    "occupants",  "guide",         "menu",        "departures",  "opening_hours",
    "small_talk", "help",          "repeat",      "cancel",      "yes",
    "no",         "speak_english", "speak_german"};

constexpr double kOfEachWord = 0.04;  // more words say it more surely
// Bytes of openings, for each example again: the ear knows all sentences.
constexpr std::size_t kMostOpened = std::size_t{4} << 20;
constexpr double kStrong = 2, kUsual = 1.3, kWeak = 0.7;

std::vector<std::string> IntentWords() { return {kWords.begin(), kWords.end()}; }

// By their names.
using Openings = std::map<std::string, std::vector<std::string>>;

ByLanguage<Openings> ReadOpenings(YamlFields& file) {
  ByLanguage<Openings> openings;
  YamlFields languages = file.Map("openings");
  for (const Language language : kLanguages) {
    for (const auto& [name, node] : languages.Pairs(Code(language))) {
      for (const LocatedText& text : languages.TextsOf(node)) {
        In(language, openings)[name.text].push_back(text.text);
      }
    }
  }
  languages.Finish();
  return openings;
}

class Reader {
 public:
  /// `opened`: bytes that the openings of all examples take so far.
  Reader(YamlFields& fields, const ByLanguage<Openings>& openings, std::size_t& opened)
      : fields_(fields), openings_(openings), opened_(opened) {}

  std::optional<IntentRow> Read() {
    IntentRow row;
    const LocatedText word = fields_.Text("intent");
    const std::optional<Intent> intent = IntentOf(word.text);
    if (!intent) {
      fields_.Error(word.where, "unknown intent \"" + word.text + "\"",
                    DidYouMean(word.text, IntentWords()));
    }
    row.needs = Kinds(fields_.Texts("needs"));
    row.takes = Kinds(fields_.Texts("takes"));
    row.is_bare = fields_.Choice("bare", "false", {"true", "false"}) == "true";
    for (const LocatedText& step : fields_.Texts("touch")) row.touch.push_back(Step(step));
    if (row.touch.empty()) fields_.Error(fields_.where(), "expected a touch path");
    YamlFields says = fields_.Map("says");
    for (const Language language : kLanguages) ReadLanguage(says, language, row);
    says.Finish();
    fields_.Finish();
    if (!intent) return std::nullopt;
    row.intent = *intent;
    return row;
  }

 private:
  std::vector<Kind> Kinds(const std::vector<LocatedText>& texts) {
    std::vector<Kind> kinds;
    for (const LocatedText& text : texts) {
      const std::optional<Kind> kind = KindOf(text.text);
      if (kind) kinds.push_back(*kind);
      if (!kind) {
        fields_.Error(text.where, "unknown slot \"" + text.text + "\"",
                      DidYouMean(text.text, KindWords()));
      }
    }
    return kinds;
  }

  std::string Step(const LocatedText& step) {
    const std::string& text = step.text;
    if (text.size() > 2 && text.front() == '{') {
      Kinds({{text.substr(1, text.size() - 2), step.where}});
    }
    return text;
  }

  void ReadLanguage(YamlFields& says, Language language, IntentRow& row) {
    YamlFields words = says.Map(Code(language));
    AddPhrases(words.Texts("strong"), kStrong, In(language, row.phrases));
    AddPhrases(words.Texts("usual"), kUsual, In(language, row.phrases));
    AddPhrases(words.Texts("weak"), kWeak, In(language, row.phrases));
    for (const LocatedText& example : words.Texts("examples")) {
      In(language, row.examples).push_back(ExampleOf(example, In(language, openings_)));
    }
    if (In(language, row.examples).empty()) {
      fields_.Error(fields_.where(), std::string("expected examples in ") + Code(language));
    }
    words.Finish();
  }

  // "(ask) where {place} is".
  Example ExampleOf(const LocatedText& example, const Openings& openings) {
    const std::size_t close = example.text.find(')');
    if (example.text.rfind('(', 0) != 0 || close == std::string::npos) return {{}, example.text};
    const std::string name = example.text.substr(1, close - 1);
    const auto found = openings.find(name);
    if (found != openings.end()) {
      for (const std::string& opening : found->second) opened_ += sizeof(opening) + opening.size();
      if (opened_ <= kMostOpened) return {found->second, example.text.substr(close + 1)};
      fields_.Error(example.where, "examples multiply to too many sentences with their openings");
      return {{}, example.text};
    }
    std::vector<std::string> names;
    for (const auto& [known, texts] : openings) names.push_back(known);
    fields_.Error(example.where, "unknown opening \"" + name + "\"", DidYouMean(name, names));
    return {{}, example.text};
  }

  static void AddPhrases(const std::vector<LocatedText>& texts, double weight,
                         std::vector<Phrase>& phrases) {
    for (const LocatedText& text : texts) {
      Phrase phrase;
      for (std::string& word : SplitWords(text.text)) {
        phrase.words.push_back(Sounding(std::move(word)));
      }
      phrase.weight = weight * (1 + kOfEachWord * static_cast<double>(phrase.words.size()));
      if (!phrase.words.empty()) phrases.push_back(std::move(phrase));
    }
  }

  YamlFields& fields_;
  const ByLanguage<Openings>& openings_;
  std::size_t& opened_;
};

}  // namespace

const char* Word(Intent intent) { return kWords[static_cast<std::size_t>(intent)]; }

std::optional<Intent> IntentOf(std::string_view word) {
  const auto found = std::find(kWords.begin(), kWords.end(), word);
  if (found == kWords.end()) return std::nullopt;
  return static_cast<Intent>(found - kWords.begin());
}

bool IntentRow::Takes(Kind kind) const {
  return std::find(takes.begin(), takes.end(), kind) != takes.end() ||
         std::find(needs.begin(), needs.end(), kind) != needs.end();
}

IntentTable LoadIntentTable(const std::string& path, Diagnostics& diagnostics) {
  IntentTable table;
  YamlFields file = YamlFields::Load(path, diagnostics);
  const ByLanguage<Openings> openings = ReadOpenings(file);
  std::size_t opened = 0;
  for (YamlFields& fields : file.Maps("intents")) {
    std::optional<IntentRow> row = Reader(fields, openings, opened).Read();
    if (!row) continue;
    const bool is_second = std::any_of(table.begin(), table.end(), [&row](const IntentRow& other) {
      return other.intent == row->intent;
    });
    if (is_second) fields.Error(fields.where(), std::string("a second ") + Word(row->intent));
    table.push_back(*std::move(row));
  }
  for (std::size_t i = 0; i < kIntents; ++i) {
    const auto intent = static_cast<Intent>(i);
    if (std::none_of(table.begin(), table.end(),
                     [intent](const IntentRow& row) { return row.intent == intent; })) {
      file.Error(file.where(), std::string("there is no intent \"") + Word(intent) + "\"");
    }
  }
  file.Finish();
  return table;
}

}  // namespace coppice::robot::knowledge
