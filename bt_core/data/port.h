// Typed ports as members of a leaf. One line declares a port and is everything that there is to say
// about it: it binds the value, makes the manifest, the editor's inspector, the type check and the
// node reference.
//
//   class DriveTo : public Action {
//    public:
//     static constexpr const char* kDescription = "Drives to a pose on the map.";
//     Input<Pose2D> goal{this, "goal", "where to, in map [m, m, rad]"};
//     Input<double> speed{this, "speed", "upper limit [m/s]", 0.5};
//     Output<double> distance{this, "distance", "driven so far [m]"};
//
// Reading costs a pointer and a test. All access is from the ticking thread. Reading an input whose
// key nobody has written yet throws UnsetInput, which the engine turns into a failure of the leaf
// that names port and key.
#ifndef COPPICE_BT_CORE_DATA_PORT_H_
#define COPPICE_BT_CORE_DATA_PORT_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/data/blackboard.h"
#include "bt_core/data/standard_types.h"

namespace coppice {

enum class PortDirection : std::uint8_t { kInput, kOutput, kInOut, kMailbox };

/// "input", "output", "inout" or "mailbox".
const char* ToString(PortDirection direction);

struct PortDeclaration {
  std::string name;
  PortDirection direction = PortDirection::kInput;
  const Type* type = nullptr;
  std::string description;
  bool required = true;  ///< must be given in the XML; false if optional or with default
  std::optional<std::string> default_text;  ///< a literal, or a key in braces
  /// The node converts: its key may hold values of another type, and a literal stays a text.
  bool converts = false;
};

struct UnsetInput : std::runtime_error {
  explicit UnsetInput(const Slot* at)
      : std::runtime_error("reads an input that has no value yet"), slot(at) {}
  const Slot* slot;  ///< null: an optional input that the XML leaves out
};

/// Base of everything that owns ports.
class PortOwner {
 public:
  PortOwner() = default;
  PortOwner(const PortOwner&) = delete;
  PortOwner& operator=(const PortOwner&) = delete;
  virtual ~PortOwner() = default;
};

/// The untyped part of a port: where it is bound to. Only the engine binds.
class PortBase {
 public:
  PortBase(const PortBase&) = delete;
  PortBase& operator=(const PortBase&) = delete;

  bool is_bound() const { return slot_ != nullptr; }
  /// `now`: begin of the present tick; must stay valid, as the slot must.
  void Bind(Slot* slot, const Time& now, SlotIndex index, const std::shared_ptr<Inbox>& inbox);

 protected:
  explicit PortBase(PortDeclaration declaration);
  ~PortBase() = default;

  Slot* slot_ = nullptr;
  const Time* now_ = nullptr;  // of the present tick

 private:
  virtual void OnBound(SlotIndex, const std::shared_ptr<Inbox>&) {}
};

/// Gathers the ports of the owners that are constructed while it lives, on this thread.
class PortCollector {
 public:
  struct Port {
    PortDeclaration declaration;
    PortBase* port;
  };
  PortCollector();
  ~PortCollector();
  PortCollector(const PortCollector&) = delete;
  PortCollector& operator=(const PortCollector&) = delete;

  std::vector<Port> ports;

 private:
  PortCollector* outer_;
};

/// Marks an input that may be left out and has no default; test has_value() before reading.
struct Optional {};
inline constexpr Optional kOptional;

template <class T>
class Input : public PortBase {
 public:
  Input(PortOwner*, std::string name, std::string description)
      : PortBase({std::move(name), PortDirection::kInput, &TypeOf<T>(), std::move(description),
                  true, std::nullopt}) {}
  Input(PortOwner*, std::string name, std::string description, const T& default_value)
      : PortBase({std::move(name), PortDirection::kInput, &TypeOf<T>(), std::move(description),
                  false, ValueTraits<T>::Print(default_value)}) {}
  Input(PortOwner*, std::string name, std::string description, Optional)
      : PortBase({std::move(name), PortDirection::kInput, &TypeOf<T>(), std::move(description),
                  false, std::nullopt}) {}

  bool has_value() const { return slot_ && slot_->value.has_value(); }
  const T& Get() const {
    if (!has_value()) throw UnsetInput(slot_);
    return slot_->value.template Get<T>();
  }
  const T& operator*() const { return Get(); }
  const T* operator->() const { return &Get(); }

  /// Counts the writes of the key; a change of the number means that somebody wrote it.
  std::uint32_t writes() const { return slot_ ? slot_->writes : 0; }
  /// Begin of the tick in which the key was written last; 0 if never. For "is this still fresh?".
  Time stamp() const { return slot_ ? slot_->stamp : Time{}; }
};

template <class T>
class Output : public PortBase {
 public:
  Output(PortOwner*, std::string name, std::string description)
      : PortBase({std::move(name), PortDirection::kOutput, &TypeOf<T>(), std::move(description),
                  false, std::nullopt}) {}

  /// Writes the key; without effect if the XML leaves the port out.
  void Set(const T& value) {
    if (!slot_) return;
    slot_->value.Set(value);
    slot_->CountWrite(*now_);
  }
};

template <class T>
class InOut : public PortBase {
 public:
  InOut(PortOwner*, std::string name, std::string description)
      : PortBase({std::move(name), PortDirection::kInOut, &TypeOf<T>(), std::move(description),
                  true, std::nullopt}) {}

  bool has_value() const { return slot_ && slot_->value.has_value(); }
  const T& Get() const {
    if (!has_value()) throw UnsetInput(slot_);
    return slot_->value.template Get<T>();
  }
  void Set(const T& value) {
    if (!slot_) return;
    slot_->value.Set(value);
    slot_->CountWrite(*now_);
  }
};

/// Where a capability's answer arrives. Not in the XML. An answer to an earlier activation is never
/// seen.
///
///   navigator_.Navigate(*goal, result_.NewSender());  // in OnStart, which returns kRunning
///   const auto* result = result_.Take();              // in OnRunning; null: not there yet
template <class T>
class Mailbox : public PortBase {
 public:
  Mailbox(PortOwner*, std::string name)
      : PortBase(
            {std::move(name), PortDirection::kMailbox, &TypeOf<T>(), "", false, std::nullopt}) {}

  /// A sender for a new question; what earlier senders send is dropped from now on.
  Sender<T> NewSender() {
    ++epoch_;
    taken_ = slot_ ? slot_->writes : 0;
    return Sender<T>(inbox_, index_, epoch_);
  }

  /// The newest answer since the last call, or null. Points into the blackboard until the next
  /// tick.
  const T* Take() {
    if (!slot_ || slot_->writes == taken_ || slot_->epoch != epoch_) return nullptr;
    taken_ = slot_->writes;
    return &slot_->value.template Get<T>();
  }

 private:
  void OnBound(SlotIndex index, const std::shared_ptr<Inbox>& inbox) override {
    index_ = index;
    inbox_ = inbox;
  }

  std::shared_ptr<Inbox> inbox_;
  SlotIndex index_ = kNoSlot;
  std::uint32_t epoch_ = 0;
  std::uint32_t taken_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_PORT_H_
