// What the tablet's page asks, answered: buttons and answers of the knowledge, the way from here to
// a place, and what the visitor wants of the robot. Takes any text; knows no sockets and no ROS.
//
// A call is a JSON object with "do" and "language" ("en", "de"); the reply is one, too:
//
//   {"do": "screen", "path": ["people"]}      {"buttons": [{"step", "label"}], "answers": false}
//   {"do": "press", "path": ["people", "ada"]} {"text", "mood", "choices", "place",
//                                              "way"}
//   {"do": "ask", "text": "wher is weber"}    the same: misspelt and half names are found
//   {"do": "choose", "number": 1}             the same: one of the "choices" of the last answer,
//                                             which asked back; 0 is the first
//   {"do": "guide", "place": "office_101"}    {}: the robot is asked to lead there
//   {"do": "stop"}                            {}: and no longer
//   {"do": "talk", "on": true}                {}: while the button is pressed, again and again
//   {"do": "touched"}, {"do": "leave"}        {}: a visitor begins; nothing of him is kept
//   {"do": "map"}                             the walls, one character for each cell
//   {"do": "state", "face": 3, "said": 1}     where the robot is; its face and what it answered to
//                                             somebody who spoke, if they are newer ones
//
// What is no such call gets {"error": "..."}. Nothing of what is asked is written anywhere, but for
// the questions without an answer that the operator sees (knowledge/store/notes.h).
#ifndef COPPICE_ROBOT_APP_TABLET_TABLET_DESK_H_
#define COPPICE_ROBOT_APP_TABLET_TABLET_DESK_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/common/occupancy_grid.h"
#include "robot_app/common/places/route_guide.h"
#include "robot_app/knowledge/answers/dialogue.h"

namespace coppice::robot::tablet {

/// What leads from the page to the robot: this and nothing else.
class TabletLinks {
 public:
  virtual ~TabletLinks() = default;
  virtual void Touched() = 0;
  /// Somebody holds the button to be heard, said again and again while he does, or lets it go.
  virtual void Talk(bool on) = 0;
  /// What the robot answers, as if it had been said. With `guides` it leads to answer.place.
  virtual void Answered(const knowledge::Answer& answer, const std::string& language) = 0;
  virtual void StopGuiding() = 0;
};

/// What the robot tells of itself.
struct TabletView {
  std::optional<Pose2D> pose;      ///< in the map frame
  std::vector<std::uint8_t> face;  ///< 64 x 32 pixels, three bytes each
  int face_number = 0;             ///< another one for another face
  knowledge::Answer said;          ///< the last answer to somebody who spoke
  int said_number = 0;             ///< another one for another answer
  std::string outcome;             ///< how the last wish to be guided ended; empty while one stands
};

class TabletDesk {
 public:
  /// The language of the dialogue is that of a page that nobody uses. `links` must outlive this.
  /// `clock`: of the site, for departures and menus.
  TabletDesk(std::unique_ptr<knowledge::Dialogue> dialogue, TopologicalMap map, TabletLinks& links,
             std::function<WallTime()> clock);

  /// Any thread; never throws.
  std::string Reply(const std::string& call);

  /// Any thread.
  void SetGrid(OccupancyGrid grid);
  void ChangeView(const std::function<void(TabletView& view)>& change);

  /// Whether a page has asked anything since this was called last: one that is open does, four
  /// times a second.
  bool TakeWasAsked();

  /// Now and then: a button to talk that is not said to be held any more was let go; the page was
  /// closed, or its battery is empty.
  void EndTalkUnlessHeld();

 private:
  using Json = nlohmann::json;
  using Handler = Json (TabletDesk::*)(const Json& call);
  struct Deed {
    const char* name;
    Handler handler;
  };
  static const Deed kDeeds[];

  Json Screen(const Json& call);
  Json Press(const Json& call);
  Json Ask(const Json& call);
  Json Choose(const Json& call);
  Json Guide(const Json& call);
  Json Stop(const Json& call);
  Json Talk(const Json& call);
  Json Touched(const Json& call);
  Json Leave(const Json& call);
  Json Map(const Json& call);
  Json State(const Json& call);
  Json ToJson(const knowledge::Answer& answer);
  Json Told(const knowledge::Answer& answer);
  Json WayTo(const std::string& place) const;
  std::string LanguageCode() const { return knowledge::Code(dialogue_->language()); }

  std::mutex mutex_;  // for all
  std::unique_ptr<knowledge::Dialogue> dialogue_;
  const std::string home_language_;
  RouteGuide guide_;
  TabletLinks& links_;
  const std::function<WallTime()> clock_;
  OccupancyGrid grid_;
  TabletView view_;
  std::vector<knowledge::Choice> choices_;  // of the answer that the page has told last
  bool was_asked_ = false;
  std::optional<WallTime> held_at_;  // the button to talk; nothing: it is not
};

}  // namespace coppice::robot::tablet

#endif  // COPPICE_ROBOT_APP_TABLET_TABLET_DESK_H_
