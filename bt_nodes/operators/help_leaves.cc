#include "bt_nodes/operators/help_leaves.h"

namespace coppice::leaves {
namespace {

// What was not asked for so long is another occasion: that nobody could help last time says
// nothing.
constexpr Duration kAnotherFault = std::chrono::seconds(60);

// A person who says that it is fixed is believed until the monitors can have seen it.
constexpr Duration kBelieved = std::chrono::seconds(10);

Duration Seconds(double seconds) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

Status RequestHelp::Run() {
  const ActionResult* answer = answer_.Take();
  // Else it is the answer to a request that has been withdrawn, or to another one.
  const bool is_ours = asked_about_ == *subject && requests_->IsOpen(asked_about_);
  if (answer && is_ours) return TakeAnswer(*answer);
  const bool is_another_fault = now() - last_run_ > kAnotherFault;
  last_run_ = now();
  if (now() < rest_until_ && !is_another_fault) {
    WakeAt(rest_until_);
    return Status::kFailure;
  }
  asked_about_ = *subject;
  const std::string text = detail->empty() ? *question : *question + " " + *detail;
  requests_->Assert({asked_about_, text, *faults}, now(), [this] { return answer_.NewSender(); });
  return Status::kFailure;
}

Status RequestHelp::TakeAnswer(const ActionResult& answer) {
  requests_->Forget(asked_about_);
  asked_about_.clear();
  if (answer.ok) {
    rest_until_ = now() + kBelieved;
    Say("a person says that it is fixed");
    return Status::kSuccess;
  }
  rest_until_ = now() + Seconds(*again);
  return Fail("nobody could help: " + answer.message);
}

Status SettleRequests::Run() {
  requests_->Settle(now(), Seconds(*linger), health.has_value() ? &*health : nullptr);
  return Status::kSuccess;
}

}  // namespace coppice::leaves
