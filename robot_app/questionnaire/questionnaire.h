// A questionnaire of semantic differentials: scales of pairs of opposite words, between which
// people make a mark. Data of a file; the shipped one is godspeed.yaml.
#ifndef COPPICE_ROBOT_APP_QUESTIONNAIRE_QUESTIONNAIRE_H_
#define COPPICE_ROBOT_APP_QUESTIONNAIRE_QUESTIONNAIRE_H_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"

namespace coppice::robot::questionnaire {

inline constexpr std::array<const char*, 2> kLanguages{"en", "de"};
using ByLanguage = std::array<std::string, kLanguages.size()>;

struct Item {
  ByLanguage low, high;  ///< the words for the lowest and for the highest mark
};

struct Scale {
  std::string id;
  ByLanguage name;
  std::vector<Item> items;
  std::optional<double> paper_alpha;  ///< what others have found
  std::vector<double> paper_medians;  ///< of each item, or empty
};

struct Questionnaire {
  ByLanguage title;
  int points = 5;  ///< marks are 1 to this
  std::vector<Scale> scales;

  /// All problems of the file go to `diagnostics`.
  static Questionnaire Load(const std::string& path, Diagnostics& diagnostics);

  /// The columns of answers: "anthropomorphism_1", ... scale by scale.
  std::vector<std::string> Columns() const;
  /// For a page: JSON.
  std::string ToJson() const;
};

/// A person's marks in the order of the columns; 0: none was made.
using Marks = std::vector<int>;

}  // namespace coppice::robot::questionnaire

#endif  // COPPICE_ROBOT_APP_QUESTIONNAIRE_QUESTIONNAIRE_H_
