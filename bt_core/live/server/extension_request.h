// One request of the extension, carried out.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_EXTENSION_REQUEST_H_
#define COPPICE_BT_CORE_LIVE_SERVER_EXTENSION_REQUEST_H_

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>

#include "bt_core/live/server/live_sessions.h"

namespace coppice {

/// A request that fails; the text is for people.
struct RequestError : std::runtime_error {
  enum class Kind { kWrong, kRefused, kRole };
  explicit RequestError(const std::string& text, Kind why = Kind::kWrong)
      : std::runtime_error(text), kind(why) {}
  Kind kind;
};

nlohmann::json ListTrees(const LiveTrees& trees);

class ExtensionRequest {
 public:
  /// `may_control`: the one who sends this request has the role for it.
  ExtensionRequest(const nlohmann::json& json, const LiveTrees& trees, Session& session,
                   bool may_control)
      : json_(json), trees_(trees), session_(session), may_control_(may_control) {}

  /// Everything but "hello" and "bye". Throws RequestError and what the JSON library throws.
  nlohmann::json Run(const std::string& what);

 private:
  using Json = nlohmann::json;
  using Handler = Json (ExtensionRequest::*)();
  struct Kind {
    const char* name;
    bool controls;  ///< needs the role
    bool disturbs;  ///< may be refused by the robot
    Handler handler;
  };
  static const Kind kKinds[];

  Json Trees();
  Json Ping();
  Json Subscribe();
  Json Acknowledge();
  Json Unsubscribe();
  Json Statistics();
  Json Write();
  Json Pause();
  Json Step();
  Json Continue();
  Json AddHook();
  Json RemoveHook();
  Json EnableHook();
  Json ListHooks();
  Json SendPictures();

  static const Kind& KindOf(const std::string& what);
  void CheckAllowed(const Kind& kind) const;
  LiveTree& Tree() const { return *SharedTree(); }
  std::shared_ptr<LiveTree> SharedTree() const;
  std::map<std::uint32_t, ActiveSubscription>::iterator FindSubscription();
  HookId NumberOfHook() const;

  const Json& json_;
  const LiveTrees& trees_;
  Session& session_;
  const bool may_control_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_EXTENSION_REQUEST_H_
