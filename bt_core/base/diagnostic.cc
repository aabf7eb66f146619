#include "bt_core/base/diagnostic.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "bt_core/base/plain.h"

namespace coppice {
namespace {

constexpr char kMeantBefore[] = "did you mean \"";
constexpr char kMeantBehind[] = "\"?";
// Beyond these a file is no longer one that people write; it could take minutes to be refused.
constexpr std::size_t kMostNames = 2000;
constexpr std::size_t kLongestName = 1000;        // letters
constexpr std::size_t kMostCompared = 1'000'000;  // letters with letters, for one name

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// Letters to insert, remove, replace or swap with their neighbour (optimal string alignment:
// Damerau 1964), with three rows of memory.
std::size_t EditDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1);  // row i - 2
  std::vector<std::size_t> above(b.size() + 1);   // row i - 1
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({substitute, above[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string ToString(const Diagnostic& diagnostic) {
  std::string text = diagnostic.where.file;
  if (diagnostic.where.line > 0) text += ":" + std::to_string(diagnostic.where.line);
  if (diagnostic.where.column > 0) text += ":" + std::to_string(diagnostic.where.column);
  if (!text.empty()) text += ": ";
  text += diagnostic.severity == Severity::kError ? "error: " : "warning: ";
  text += diagnostic.message;
  if (!diagnostic.hint.empty()) text += " (" + diagnostic.hint + ")";
  return PlainLine(text);
}

void Diagnostics::Add(Diagnostic diagnostic) {
  const bool is_error = diagnostic.severity == Severity::kError;
  int& count = is_error ? errors_ : warnings_;
  ++count;
  if (count <= kMostOfAKind) {
    all_.push_back(std::move(diagnostic));
  } else if (count == kMostOfAKind + 1) {
    diagnostic.message = is_error ? "and more errors, not told" : "and more warnings, not told";
    diagnostic.hint.clear();
    diagnostic.about = {};
    all_.push_back(std::move(diagnostic));
  }
}

void Diagnostics::Error(SourceLocation where, std::string message, std::string hint,
                        ProblemSubject about) {
  Add({Severity::kError, std::move(where), std::move(message), std::move(hint), std::move(about)});
}

void Diagnostics::Warning(SourceLocation where, std::string message, std::string hint,
                          ProblemSubject about) {
  Add({Severity::kWarning, std::move(where), std::move(message), std::move(hint),
       std::move(about)});
}

void Diagnostics::Append(const Diagnostics& other) {
  for (const Diagnostic& diagnostic : other.all_) Add(diagnostic);
}

std::string Diagnostics::ToString() const {
  std::string text;
  for (const Diagnostic& diagnostic : all_) text += coppice::ToString(diagnostic) + "\n";
  return text;
}

std::string NearestName(std::string_view name, const std::vector<std::string>& candidates) {
  if (candidates.size() > kMostNames) return {};
  const std::string wanted = Lower(name);
  std::size_t best_distance = std::max<std::size_t>(1, wanted.size() / 3) + 1;
  std::string best;
  std::size_t compared = 0;
  for (const std::string& candidate : candidates) {
    const std::size_t longer = std::max(wanted.size(), candidate.size());
    const std::size_t shorter = std::min(wanted.size(), candidate.size());
    if (longer - shorter >= best_distance || shorter > kLongestName) continue;
    compared += longer * shorter;
    if (compared > kMostCompared) break;
    const std::size_t distance = EditDistance(wanted, Lower(candidate));
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string DidYouMean(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string nearest = NearestName(name, candidates);
  return nearest.empty() ? std::string() : kMeantBefore + nearest + kMeantBehind;
}

std::string NameMeant(std::string_view hint) {
  const std::string_view before = kMeantBefore;
  const std::string_view behind = kMeantBehind;
  if (hint.size() < before.size() + behind.size() || hint.substr(0, before.size()) != before ||
      hint.substr(hint.size() - behind.size()) != behind) {
    return {};
  }
  hint.remove_prefix(before.size());
  hint.remove_suffix(behind.size());
  return std::string(hint);
}

}  // namespace coppice
