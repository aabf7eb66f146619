// Asking people for help without waiting for them: RequestHelp and SettleRequests, which go
// together in one tree.
#ifndef COPPICE_BT_NODES_OPERATORS_HELP_LEAVES_H_
#define COPPICE_BT_NODES_OPERATORS_HELP_LEAVES_H_

#include <memory>
#include <string>

#include "bt_core/nodes/leaf.h"
#include "bt_nodes/operators/open_requests.h"

namespace coppice::leaves {

/// The last rung of a ladder. Fails at once while nobody has fixed it, so that a Fallback goes on
/// to less urgent faults; succeeds once when a person has confirmed, and
/// asks nobody for the ten seconds that the monitors may need to see it.
class RequestHelp : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Keeps a request for help open as long as it is ticked. Fails while nobody has fixed it, "
      "succeeds when a person has confirmed it. Needs SettleRequests in the same tree.";
  explicit RequestHelp(std::shared_ptr<OpenRequests> requests) : requests_(std::move(requests)) {}
  Input<std::string> subject{this, "subject", "what the request is about; one request for each"};
  Input<std::string> question{this, "question", "what is wrong and what to do"};
  Input<std::string> detail{this, "detail", "stands behind the question", ""};
  Input<std::string> faults{this, "faults",
                            "kinds of monitors (navigation;...) whose errors keep the request open "
                            "while a more urgent fault is handled",
                            ""};
  Input<double> again{this, "again", "asks again so long after nobody could help [s]", 600};
  Status Run() override;

 private:
  Status TakeAnswer(const ActionResult& answer);

  std::shared_ptr<OpenRequests> requests_;
  Mailbox<ActionResult> answer_{this, "answer"};
  std::string asked_about_;
  Time rest_until_{};  // nobody could help: not asked before
  Time last_run_{};
};

/// To be ticked in every tick, behind everything that requests help.
class SettleRequests : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Withdraws the requests for help whose faults have gone: those that RequestHelp no longer "
      "asserts. Always succeeds.";
  explicit SettleRequests(std::shared_ptr<OpenRequests> requests)
      : requests_(std::move(requests)) {}
  Input<Health> health{this, "health", "from ReadHealth", kOptional};
  Input<double> linger{this, "linger", "a request stands so long without being asserted [s]", 1};
  Status Run() override;

 private:
  std::shared_ptr<OpenRequests> requests_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_OPERATORS_HELP_LEAVES_H_
