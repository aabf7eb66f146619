// A list of functions that are called when something happens.
#ifndef SIMPLE_SIGNAL_H
#define SIMPLE_SIGNAL_H

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace BT {

/// A function is called for as long as its Subscriber lives. Not locked: one thread.
template <class... Arguments>
class Signal {
 public:
  using CallableFunction = std::function<void(Arguments...)>;
  using Subscriber = std::shared_ptr<CallableFunction>;

  void notify(Arguments... arguments) {
    for (std::size_t k = 0; k < subscribers_.size(); ++k) {  // a callback may subscribe
      if (const Subscriber subscriber = subscribers_[k].lock()) (*subscriber)(arguments...);
    }
    Forget();
  }

  Subscriber subscribe(CallableFunction function) {
    auto subscriber = std::make_shared<CallableFunction>(std::move(function));
    subscribers_.push_back(subscriber);
    return subscriber;
  }

  bool has_subscribers() {
    Forget();
    return !subscribers_.empty();
  }

 private:
  void Forget() {
    const auto is_gone = [](const auto& subscriber) { return subscriber.expired(); };
    subscribers_.erase(std::remove_if(subscribers_.begin(), subscribers_.end(), is_gone),
                       subscribers_.end());
  }

  std::vector<std::weak_ptr<CallableFunction>> subscribers_;
};

}  // namespace BT

#endif  // SIMPLE_SIGNAL_H
