// The buttons that lead to every intent: the touch paths of the intent table with what the
// knowledge has for their choices. A page draws them; what is pressed at the end is the same
// Request that could have been said.
//
//   TouchMenu menu(table, texts, database, Language::kEnglish);
//   menu.After({}).buttons                       // Places, Nearby, People, Menu, Departures, ...
//   menu.After({"places", "restroom"}).request   // list_places, category = restroom
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_TOUCH_MENU_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_TOUCH_MENU_H_

#include <optional>
#include <string>
#include <vector>

#include "robot_app/knowledge/answers/answer_texts.h"
#include "robot_app/knowledge/store/database.h"
#include "robot_app/knowledge/understanding/understanding.h"

namespace coppice::robot::knowledge {

struct TouchButton {
  std::string step;   ///< to be added to the path
  std::string label;  ///< for people
};

struct TouchScreen {
  std::optional<Request> request;    ///< what this path means, if it means something
  std::vector<TouchButton> buttons;  ///< where it goes on
};

/// All must outlive this.
class TouchMenu {
 public:
  TouchMenu(const IntentTable& table, const AnswerTexts& texts, const Database& database,
            Language language)
      : table_(table), texts_(texts), database_(database), language_(language) {}

  /// Empty for a path that no button leads to.
  TouchScreen After(const std::vector<std::string>& path) const;

 private:
  bool Follows(const IntentRow& row, const std::vector<std::string>& path, Request& request) const;
  std::vector<TouchButton> Choices(const std::string& step, const Request& request) const;

  const IntentTable& table_;
  const AnswerTexts& texts_;
  const Database& database_;
  Language language_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_TOUCH_MENU_H_
