// Two node types.
#include "bt_core/engine/plugin.h"

namespace {

using coppice::Status;

class Half : public coppice::SyncAction {
 public:
  static constexpr const char* kDescription = "Halves a number.";
  coppice::Input<double> number{this, "number", "what"};
  coppice::Output<double> half{this, "half", "half of it"};
  Status Run() override {
    half.Set(*number / 2);
    return Status::kSuccess;
  }
};

}  // namespace

COPPICE_PLUGIN(registry) {
  registry.Register<Half>("Half");
  registry.Condition("IsSmall", {"number"}, [](double number) { return number < 1; });
}
