#include "editor/simulation/script_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <tuple>
#include <utility>

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

// "80%"
std::optional<double> ShareFrom(const std::string& word) {
  char* end = nullptr;
  const double share = std::strtod(word.c_str(), &end);
  const bool is_share =
      end != word.c_str() && std::string(end) == "%" && share >= 0 && share <= 100;
  return is_share ? std::optional(share) : std::nullopt;
}

// "0.5s..2s"; "2s": neither less nor more
std::optional<std::pair<Duration, Duration>> TimeFrom(const std::string& word) {
  const std::size_t dots = word.find("..");
  const auto shortest = DurationFrom(word.substr(0, dots));
  const auto longest = dots == std::string::npos ? shortest : DurationFrom(word.substr(dots + 2));
  if (!shortest || !longest || *longest < *shortest) return std::nullopt;
  return std::pair(*shortest, *longest);
}

bool AddShare(Chances& chances, double share, const std::string& word) {
  const std::optional<Status> status = StatusFrom(word);
  if (!status || *status == Status::kRunning) return false;
  (*status == Status::kSuccess   ? chances.success
   : *status == Status::kFailure ? chances.failure
                                 : chances.skipped) += share;
  return true;
}

// "80% SUCCESS 20% FAILURE 0s..2s holds 5s"
Expected<MockScript> ParseChances(std::istringstream words) {
  Chances chances;
  for (std::string word; words >> word;) {
    if (const auto share = ShareFrom(word)) {
      if (words >> word && AddShare(chances, *share, word)) continue;
      return Problem{"after a share comes SUCCESS, FAILURE or SKIPPED"};
    }
    const bool holds = word == "holds" && words >> word;
    if (const auto range = TimeFrom(word)) {
      (holds ? std::tie(chances.shortest_hold, chances.longest_hold)
             : std::tie(chances.shortest, chances.longest)) = *range;
    } else {
      return Problem{"\"" + word + "\" is no share such as 80%, no time such as 0s..2s"};
    }
  }
  if (chances.success + chances.failure + chances.skipped <= 0) {
    return Problem{"say of what, for example \"80% SUCCESS 20% FAILURE 0s..2s\""};
  }
  MockScript script;
  script.chances = chances;
  return script;
}

std::string PrintChances(const Chances& chances) {
  const double all = chances.success + chances.failure + chances.skipped;
  std::string words;
  const auto add = [&](double share, Status status) {
    if (share <= 0) return;
    char text[48];
    std::snprintf(text, sizeof(text), "%.4g%% %s ", 100 * share / all, ToString(status));
    words += text;
  };
  add(chances.success, Status::kSuccess);
  add(chances.failure, Status::kFailure);
  add(chances.skipped, Status::kSkipped);
  const auto add_time = [&](const char* before, Duration shortest, Duration longest) {
    if (longest <= Duration(0)) return;
    words += before + PrintDuration(shortest) + ".." + PrintDuration(longest) + " ";
  };
  add_time("", chances.shortest, chances.longest);
  add_time("holds ", chances.shortest_hold, chances.longest_hold);
  words.pop_back();
  return words;
}

}  // namespace

Expected<MockScript> ParseScript(const std::string& text) {
  MockScript script;
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream words(spaced);
  if (text.find('%') != std::string::npos) return ParseChances(std::move(words));
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
      return Problem{"\"" + word +
                     "\" is no SUCCESS, FAILURE, RUNNING or SKIPPED, no time such as 2s, no x3"};
    }
    if (script.results.size() > kMostResults) {
      return Problem{"that is more than " + std::to_string(kMostResults) + " results"};
    }
  }
  if (script.results.empty() && script.duration == Duration(0)) {
    return Problem{"say what it returns, for example \"2s FAILURE\""};
  }
  return script;
}

std::string PrintDuration(Duration duration) {
  char text[48];
  const double seconds = static_cast<double>(duration.count()) * 1e-9;
  std::snprintf(text, sizeof(text), seconds < 1 ? "%.6gms" : "%.9gs",
                seconds < 1 ? seconds * 1000 : seconds);
  return text;
}

std::string PrintScript(const MockScript& script) {
  if (script.chances) return PrintChances(*script.chances);
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
