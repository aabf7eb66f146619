#include "robot_app/common/configuration/site_phrases.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <utility>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot {
namespace {

constexpr char kPlaceholder[] = "{about}";
constexpr const char* kLanguages[] = {"en", "de"};  // the first one stands for others

// "05:30" in minutes; negative: no such time.
int ParseMinute(const std::string& text) {
  int hour = 0, minute = 0, end = 0;
  const int read = std::sscanf(text.c_str(), "%2d:%2d%n", &hour, &minute, &end);
  const bool is_time = read == 2 && end == static_cast<int>(text.size()) && hour >= 0 &&
                       hour < 24 && minute >= 0 && minute < 60;
  return is_time ? hour * 60 + minute : -1;
}

}  // namespace

int MinuteOfLocalDay() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return local.tm_hour * 60 + local.tm_min;
}

SitePhrases::SitePhrases(const std::string& path, Diagnostics& diagnostics, MinuteOfDay minute)
    : minute_(std::move(minute)) {
  YamlFields file = YamlFields::Load(path, diagnostics);
  for (const Enumerator& phrase : ValueTraits<leaves::Phrase>::kEnumerators) {
    std::vector<Row>& rows = phrases_.emplace_back();
    for (YamlFields& fields : file.Maps(std::string(phrase.name))) {
      Row& row = rows.emplace_back();
      const LocatedText from = fields.Text("from", "00:00");
      row.from = ParseMinute(from.text);
      if (row.from < 0) fields.Error(from.where, "from: expected a time such as \"05:30\"");
      for (const char* language : kLanguages) row.texts[language] = fields.Text(language).text;
      fields.Finish();
    }
    if (rows.empty()) {
      file.Error(file.where(), "expected the phrase " + std::string(phrase.name));
      rows.emplace_back();
    }
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Row& a, const Row& b) { return a.from < b.from; });
  }
  file.Finish();
}

// Before the first row's time the last one of the day before holds.
const SitePhrases::Row& SitePhrases::RowOfNow(const std::vector<Row>& rows) const {
  const int now = minute_();
  const Row* found = &rows.back();
  for (const Row& row : rows) {
    if (row.from <= now) found = &row;
  }
  return *found;
}

std::string SitePhrases::Text(leaves::Phrase phrase, const std::string& language,
                              const std::string& about) {
  const Row& row = RowOfNow(phrases_.at(static_cast<std::size_t>(phrase)));
  const auto found = row.texts.find(language);
  std::string text = found != row.texts.end() ? found->second : row.texts.at(kLanguages[0]);
  const std::size_t at = text.find(kPlaceholder);
  if (at != std::string::npos) text.replace(at, sizeof(kPlaceholder) - 1, about);
  return text;
}

}  // namespace coppice::robot
