// Which classes derive from which, so that a port of a std::shared_ptr to one can read a key that
// holds one to another.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <shared_mutex>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

namespace BT {

/// Any thread.
class PolymorphicCastRegistry {
 public:
  PolymorphicCastRegistry() = default;
  PolymorphicCastRegistry(const PolymorphicCastRegistry&) = delete;
  PolymorphicCastRegistry& operator=(const PolymorphicCastRegistry&) = delete;

  template <class Derived, class Base>
  void registerCast() {
    static_assert(std::is_base_of_v<Base, Derived>, "Derived must derive from Base");
    static_assert(std::is_polymorphic_v<Base>, "Base must have a virtual function");
    const std::type_index derived = typeid(std::shared_ptr<Derived>);
    const std::type_index base = typeid(std::shared_ptr<Base>);
    const std::unique_lock lock(mutex_);
    bases_[derived].insert(base);
    steps_[{derived, base}] = [](const std::shared_ptr<void>& from) {
      std::shared_ptr<Base> to = *std::static_pointer_cast<std::shared_ptr<Derived>>(from);
      return std::static_pointer_cast<void>(std::make_shared<std::shared_ptr<Base>>(to));
    };
    steps_[{base, derived}] = [](const std::shared_ptr<void>& from) -> std::shared_ptr<void> {
      auto to = std::dynamic_pointer_cast<Derived>(
          *std::static_pointer_cast<std::shared_ptr<Base>>(from));
      return to ? std::make_shared<std::shared_ptr<Derived>>(to) : nullptr;
    };
    const auto copy = [](auto pointer) {
      using P = decltype(pointer);
      return Copier{[](const void* at) -> std::shared_ptr<void> {
                      return std::make_shared<P>(*static_cast<const P*>(at));
                    },
                    [](const std::shared_ptr<void>& from, void* at) {
                      *static_cast<P*>(at) = *std::static_pointer_cast<P>(from);
                    }};
    };
    copiers_[derived] = copy(std::shared_ptr<Derived>());
    copiers_[base] = copy(std::shared_ptr<Base>());
  }

  /// Upwards over any number of steps, downwards over one.
  bool isConvertible(std::type_index from, std::type_index to) const {
    if (from == to) return true;
    const std::shared_lock lock(mutex_);
    return !Path(from, to).empty() || steps_.count({from, to}) > 0;
  }
  bool canUpcast(std::type_index from, std::type_index to) const {
    const std::shared_lock lock(mutex_);
    return from == to || !Path(from, to).empty();
  }
  std::set<std::type_index> getBaseTypes(std::type_index type) const {
    const std::shared_lock lock(mutex_);
    const auto found = bases_.find(type);
    return found == bases_.end() ? std::set<std::type_index>() : found->second;
  }
  void clear() {
    const std::unique_lock lock(mutex_);
    bases_.clear();
    steps_.clear();
    copiers_.clear();
  }

  /// Writes the pointer at `from` to the one at `to`, upwards or downwards. False if there is no
  /// way, or the object is not of that class.
  bool Cast(const void* from, std::type_index from_type, void* to, std::type_index to_type) const {
    const std::shared_lock lock(mutex_);
    const auto source = copiers_.find(from_type);
    const auto target = copiers_.find(to_type);
    if (source == copiers_.end() || target == copiers_.end()) return false;
    std::vector<std::type_index> path = Path(from_type, to_type);
    if (path.empty()) {
      path = Path(to_type, from_type);
      path = std::vector<std::type_index>(path.rbegin(), path.rend());
    }
    if (path.empty()) return false;
    std::shared_ptr<void> pointer = source->second.read(from);
    for (std::size_t k = 0; pointer && k + 1 < path.size(); ++k) {
      pointer = steps_.at({path[k], path[k + 1]})(pointer);
    }
    if (pointer) target->second.write(pointer, to);
    return pointer != nullptr;
  }

 private:
  using Step = std::function<std::shared_ptr<void>(const std::shared_ptr<void>&)>;
  struct Copier {
    std::function<std::shared_ptr<void>(const void*)> read;
    std::function<void(const std::shared_ptr<void>&, void*)> write;
  };

  // From a class up to a base of it, both included; empty if it is none.
  std::vector<std::type_index> Path(std::type_index from, std::type_index to) const {
    std::set<std::type_index> seen{from};
    std::vector<std::vector<std::type_index>> paths{{from}};
    for (std::size_t k = 0; k < paths.size(); ++k) {
      const auto found = bases_.find(paths[k].back());
      if (found == bases_.end()) continue;
      for (const std::type_index base : found->second) {
        if (!seen.insert(base).second) continue;
        paths.push_back(paths[k]);
        paths.back().push_back(base);
        if (base == to) return paths.back();
      }
    }
    return {};
  }

  mutable std::shared_mutex mutex_;
  std::map<std::type_index, std::set<std::type_index>> bases_;
  std::map<std::pair<std::type_index, std::type_index>, Step> steps_;
  std::map<std::type_index, Copier> copiers_;
};

}  // namespace BT
