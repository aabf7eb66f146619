// What answers say: medians, and whether the items of a scale measure the same. Pure; any thread.
#ifndef COPPICE_ROBOT_APP_QUESTIONNAIRE_FIGURES_H_
#define COPPICE_ROBOT_APP_QUESTIONNAIRE_FIGURES_H_

#include <optional>
#include <string>
#include <vector>

#include "robot_app/questionnaire/questionnaire.h"

namespace coppice::robot::questionnaire {

/// The middle one, or the mean of the middle two; nothing of no values.
std::optional<double> Median(std::vector<double> values);

/// L. J. Cronbach, Coefficient alpha and the internal structure of tests, Psychometrika 16 (1951):
/// k / (k - 1) * (1 - sum of the items' variances / variance of the sums), over `rows` of k marks
/// each. Nothing with fewer than two rows or items, or if all sums are the same.
std::optional<double> CronbachAlpha(const std::vector<std::vector<double>>& rows);

/// A line for each scale: alpha and medians, and beside them those of the paper. Alpha counts the
/// people who have marked all items of the scale, a median those who have marked the item.
std::string FiguresText(const Questionnaire& questionnaire, const std::vector<Marks>& people);

}  // namespace coppice::robot::questionnaire

#endif  // COPPICE_ROBOT_APP_QUESTIONNAIRE_FIGURES_H_
