#include "editor/simulation/script_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace coppice::editor {
namespace {

constexpr std::size_t kMostResults = 10000;
constexpr double kLongest = 1e9;  // seconds: some thirty years
constexpr Status kResults[] = {Status::kRunning, Status::kSuccess, Status::kFailure,
                               Status::kSkipped};

std::optional<Status> StatusFrom(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  for (const Status status : kResults) {
    if (!word.empty() && std::string(ToString(status)).rfind(word, 0) == 0) return status;
  }
  return std::nullopt;
}

// "2s", "0.5s", "300ms"
std::optional<Duration> DurationFrom(const std::string& word) {
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  const std::string unit = end;
  if (end == word.c_str() || (unit != "s" && unit != "ms")) return std::nullopt;
  const double seconds = unit == "s" ? number : number / 1000;
  if (!(seconds >= 0 && seconds <= kLongest)) return std::nullopt;
  return Duration(std::llround(seconds * 1e9));
}

// "x3"
std::optional<std::size_t> TimesFrom(const std::string& word) {
  const bool digits =
      word.size() > 1 && word.size() < 6 && word[0] == 'x' &&
      std::all_of(word.begin() + 1, word.end(), [](unsigned char c) { return std::isdigit(c); });
  return digits ? std::optional<std::size_t>(std::stoul(word.substr(1))) : std::nullopt;
}

std::string PrintDuration(Duration duration) {
  char text[48];
  const double seconds = static_cast<double>(duration.count()) * 1e-9;
  std::snprintf(text, sizeof(text), seconds < 1 ? "%.6gms" : "%.9gs",
                seconds < 1 ? seconds * 1000 : seconds);
  return text;
}

}  // namespace

std::optional<MockScript> ParseScript(const std::string& text, std::string& why) {
  MockScript script;
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream words(spaced);
  for (std::string word; words >> word;) {
    if (word == "each") {
      script.restart = true;
    } else if (const auto duration = DurationFrom(word)) {
      script.duration = *duration;
    } else if (const auto times = TimesFrom(word); times && !script.results.empty()) {
      script.results.insert(script.results.end(), std::max<std::size_t>(*times, 1) - 1,
                            Status(script.results.back()));
    } else if (const auto status = StatusFrom(word)) {
      script.results.push_back(*status);
    } else {
      why =
          "\"" + word + "\" is no SUCCESS, FAILURE, RUNNING or SKIPPED, no time such as 2s, no x3";
      return std::nullopt;
    }
    if (script.results.size() > kMostResults) {
      why = "that is more than " + std::to_string(kMostResults) + " results";
      return std::nullopt;
    }
  }
  if (script.results.empty() && script.duration == Duration(0)) {
    why = "say what it returns, for example \"2s FAILURE\"";
    return std::nullopt;
  }
  return script;
}

std::string PrintScript(const MockScript& script) {
  std::string text = script.restart ? "each" : "";
  const auto add = [&text](const std::string& word) { text += (text.empty() ? "" : " ") + word; };
  if (script.duration > Duration(0)) add(PrintDuration(script.duration));
  for (std::size_t i = 0; i < script.results.size();) {
    std::size_t end = i;
    while (end < script.results.size() && script.results[end] == script.results[i]) ++end;
    add(ToString(script.results[i]));
    if (end - i > 1) add("x" + std::to_string(end - i));
    i = end;
  }
  if (script.results.empty()) add(ToString(Status::kSuccess));
  return text;
}

}  // namespace coppice::editor
