// Named values that nodes share; one for each SubTree, with the keys of the tree outside where they
// are remapped.
//
// What a tree uses lies in the slots of the tree's executor, so that ticking looks up no name; a
// Blackboard is a view of them by name, and holds what only C++ code uses. All functions may be
// called by any thread; a thread that does not tick the tree waits until the tick is over.
#pragma once

#include <memory>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "behaviortree_cpp/basic_types.h"
#include "behaviortree_cpp/contrib/json.hpp"
#include "behaviortree_cpp/internal/cell.h"
#include "behaviortree_cpp/utils/locked_reference.hpp"

namespace BT {

using AnyPtrLocked = LockedPtr<Any>;

template <class T>
struct StampedValue {
  T value;
  Timestamp stamp;
};

class Blackboard {
 public:
  using Ptr = std::shared_ptr<Blackboard>;

  /// A key as it was when it was asked for; to write, call set().
  struct Entry {
    Any value;
    TypeInfo info;
    StringConverter string_converter;
    mutable std::mutex entry_mutex;
    uint64_t sequence_id = 0;
    std::chrono::nanoseconds stamp{0};

    explicit Entry(const TypeInfo& declared) : info(declared) {}
  };

  static Ptr create(Ptr parent = {}) { return Ptr(new Blackboard(std::move(parent))); }
  virtual ~Blackboard() = default;
  Blackboard(const Blackboard&) = delete;
  Blackboard& operator=(const Blackboard&) = delete;

  /// Keys that are not here are those of the parent, but for private ones ("_x").
  void enableAutoRemapping(bool remapping) { autoremapping_ = remapping; }
  void addSubtreeRemapping(StringView internal, StringView external);

  /// Null if there is no such key. "@key": of the outermost blackboard.
  std::shared_ptr<Entry> getEntry(const std::string& key);
  const std::shared_ptr<Entry> getEntry(const std::string& key) const;
  const TypeInfo* entryInfo(const std::string& key);
  AnyPtrLocked getAnyLocked(const std::string& key);
  AnyPtrLocked getAnyLocked(const std::string& key) const;

  /// False if the key is missing or empty. Throws std::runtime_error if its value is no T.
  template <class T>
  bool get(const std::string& key, T& value) const;
  /// Throws RuntimeError if the key is missing or empty, std::runtime_error if its value is no T.
  template <class T>
  T get(const std::string& key) const;
  template <class T>
  Expected<Timestamp> getStamped(const std::string& key, T& value) const;
  template <class T>
  Expected<StampedValue<T>> getStamped(const std::string& key) const;

  /// Throws LogicError if the key has another type, unless the value can be converted safely.
  template <class T>
  void set(const std::string& key, const T& value);
  void unset(const std::string& key);
  void createEntry(const std::string& key, const TypeInfo& info);

  void debugMessage() const;
  /// Of this blackboard; they hold as long as the keys do.
  std::vector<StringView> getKeys() const;
  [[deprecated("use backup and restore")]] void clear();
  /// Values and types of all keys; `destination` loses what this has not.
  void cloneInto(Blackboard& destination) const;

  Ptr parent() { return parent_.lock(); }
  Blackboard* rootBlackboard();
  const Blackboard* rootBlackboard() const;

  void setPolymorphicCastRegistry(std::shared_ptr<PolymorphicCastRegistry> registry) {
    casts_ = std::move(registry);
  }
  const PolymorphicCastRegistry* polymorphicCastRegistry() const { return casts_.get(); }
  template <class T>
  Expected<T> tryCastWithPolymorphicFallback(const Any* any) const {
    auto converted = any->tryCast<T>();
    if constexpr (is_shared_ptr<T>::value) {
      if (!converted && casts_) {
        if (auto cast = any->tryCastWithRegistry<T>(*casts_)) return cast;
      }
    }
    return converted;
  }

  /// For the engine: the cell of a key, null if there is none; the others make it, where the key
  /// is remapped to or here.
  std::shared_ptr<internal::Cell> FindCell(StringView key) const;
  std::shared_ptr<internal::Cell> MakeCell(StringView key, const TypeInfo& info = {});
  std::shared_ptr<internal::Cell> OwnCell(StringView key);

 protected:
  explicit Blackboard(Ptr parent) : parent_(parent), keep_(std::move(parent)) {}

 private:
  friend class Tree;
  template <class T>
  Expected<T> Read(const internal::Cell& cell) const {
    const Any value = Copy(cell);
    return tryCastWithPolymorphicFallback<T>(&value);
  }
  static Any Copy(const internal::Cell& cell);
  static Timestamp StampOf(const internal::Cell& cell);

  mutable std::shared_mutex mutex_;
  std::unordered_map<std::string, std::shared_ptr<internal::Cell>> cells_;
  std::weak_ptr<Blackboard> parent_;
  Ptr keep_;
  std::unordered_map<std::string, std::string> remapped_;
  std::shared_ptr<PolymorphicCastRegistry> casts_;
  bool autoremapping_ = false;
};

nlohmann::json ExportBlackboardToJSON(const Blackboard& blackboard);
void ImportBlackboardFromJSON(const nlohmann::json& json, Blackboard& blackboard);

template <class T>
bool Blackboard::get(const std::string& key, T& value) const {
  const auto cell = FindCell(key);
  if (!cell) return false;
  const Any found = Copy(*cell);
  if (found.empty()) return false;
  auto converted = tryCastWithPolymorphicFallback<T>(&found);
  if (!converted) throw std::runtime_error(converted.error());
  value = *std::move(converted);
  return true;
}

template <class T>
T Blackboard::get(const std::string& key) const {
  const auto cell = FindCell(key);
  if (!cell) throw RuntimeError("Blackboard::get() error. Missing key [", key, "]");
  const Any found = Copy(*cell);
  if (found.empty()) {
    throw RuntimeError("Blackboard::get() error. Entry [", key, "] hasn't been initialized, yet");
  }
  auto converted = tryCastWithPolymorphicFallback<T>(&found);
  if (!converted) throw std::runtime_error(converted.error());
  return *std::move(converted);
}

template <class T>
Expected<Timestamp> Blackboard::getStamped(const std::string& key, T& value) const {
  const auto cell = FindCell(key);
  if (!cell) {
    return nonstd::make_unexpected(
        StrCat("Blackboard::getStamped() error. Missing key [", key, "]"));
  }
  const Any found = Copy(*cell);
  if (found.empty()) {
    return nonstd::make_unexpected(
        StrCat("Blackboard::getStamped() error. Entry [", key, "] hasn't been initialized, yet"));
  }
  auto converted = tryCastWithPolymorphicFallback<T>(&found);
  if (!converted) return nonstd::make_unexpected(converted.error());
  value = *std::move(converted);
  return StampOf(*cell);
}

template <class T>
Expected<StampedValue<T>> Blackboard::getStamped(const std::string& key) const {
  StampedValue<T> out;
  const Expected<Timestamp> stamp = getStamped(key, out.value);
  if (!stamp) return nonstd::make_unexpected(stamp.error());
  out.stamp = *stamp;
  return out;
}

template <class T>
void Blackboard::set(const std::string& key, const T& value) {
  auto cell = FindCell(key);
  if (!cell) cell = MakeCell(key);
  internal::WriteTo(*cell, value, key);
}

}  // namespace BT
