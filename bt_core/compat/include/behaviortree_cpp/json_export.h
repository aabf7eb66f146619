// JSON of the types of users: for the live view, backups and literals in XML.
//
//   BT_JSON_CONVERTER(Pose2D, pose) {
//     add_field("x", &pose.x);
//     add_field("y", &pose.y);
//   }
//   BT::RegisterJsonDefinition<Pose2D>();
//
// Converters are registered before trees are made; afterwards any thread may convert.
#pragma once

#include <functional>
#include <string>
#include <typeindex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "behaviortree_cpp/basic_types.h"
#include "behaviortree_cpp/contrib/json.hpp"

namespace BT {

class JsonExporter {
 public:
  using Entry = std::pair<Any, TypeInfo>;
  using ExpectedEntry = nonstd::expected<Entry, std::string>;

  static JsonExporter& get();
  JsonExporter(const JsonExporter&) = delete;
  JsonExporter& operator=(const JsonExporter&) = delete;

  /// False if the type of the value is not known.
  bool toJson(const Any& any, nlohmann::json& destination) const;

  /// Of the type that "__type" names, or a number, text, truth value or list of them.
  ExpectedEntry fromJson(const nlohmann::json& source) const;
  ExpectedEntry fromJson(const nlohmann::json& source, std::type_index type) const;
  template <class T>
  Expected<T> fromJson(const nlohmann::json& source) const {
    const ExpectedEntry entry = fromJson(source);
    if (!entry) return nonstd::make_unexpected(entry.error());
    return entry->first.tryCast<T>();
  }

  /// A type with to_json and from_json, as BT_JSON_CONVERTER makes them.
  template <class T>
  void addConverter() {
    const nlohmann::json example = T{};
    if (example.contains("__type")) Name<T>(example["__type"].template get<std::string>());
    Name<T>(demangle(typeid(T)));
    AddWriter<T>([](const T& value, nlohmann::json& json) { json = value; });
    AddReader<T>([](const nlohmann::json& json, T& value) { json.get_to(value); });
  }
  template <class T>
  void addConverter(std::function<void(const T&, nlohmann::json&)> to_json, bool add_type = true) {
    AddWriter<T>([to_json, add_type](const T& value, nlohmann::json& json) {
      to_json(value, json);
      if (add_type) json["__type"] = demangle(typeid(T));
    });
  }
  template <class T>
  void addConverter(std::function<void(const nlohmann::json&, T&)> from_json) {
    Name<T>(demangle(typeid(T)));
    AddReader<T>(std::move(from_json));
  }

 private:
  using Writer = std::function<void(const Any&, nlohmann::json&)>;
  using Reader = std::function<Entry(const nlohmann::json&)>;

  JsonExporter() = default;

  template <class T>
  void Name(const std::string& name) {
    types_.insert({name, TypeInfo::Create<T>()});
  }

  template <class T, class Function>
  void AddWriter(Function write) {
    writers_[typeid(T)] = [write](const Any& any, nlohmann::json& json) {
      write(any.cast<T>(), json);
    };
    writers_[typeid(std::vector<T>)] = [write](const Any& any, nlohmann::json& json) {
      json = nlohmann::json::array();
      for (const T& value : any.cast<std::vector<T>>()) {
        nlohmann::json element;
        write(value, element);
        json.push_back(std::move(element));
      }
    };
  }

  template <class T, class Function>
  void AddReader(Function read) {
    readers_[typeid(T)] = [read](const nlohmann::json& json) {
      T value{};
      read(json, value);
      return Entry{Any(value), TypeInfo::Create<T>()};
    };
    list_readers_[typeid(T)] = [read](const nlohmann::json& json) {
      std::vector<T> values;
      for (const nlohmann::json& element : json) {
        values.emplace_back();
        read(element, values.back());
      }
      return Entry{Any(values), TypeInfo::Create<std::vector<T>>()};
    };
    readers_[typeid(std::vector<T>)] = list_readers_[typeid(T)];
  }

  std::unordered_map<std::type_index, Writer> writers_;
  std::unordered_map<std::type_index, Reader> readers_;
  std::unordered_map<std::type_index, Reader> list_readers_;  // by the type of the elements
  std::unordered_map<std::string, TypeInfo> types_;
};

template <class T>
void RegisterJsonDefinition() {
  JsonExporter::get().addConverter<T>();
}

}  // namespace BT

/// Followed by the body of a function that lists the fields of `value`: add_field("x", &value.x).
#define BT_JSON_CONVERTER(Type, value)                                                    \
  template <class AddField>                                                               \
  void _JsonTypeDefinition(Type&, AddField&);                                             \
  inline void to_json(nlohmann::json& json, const Type& from) {                           \
    auto write = [&json](const char* name, auto* field) { json[name] = *field; };         \
    _JsonTypeDefinition(const_cast<Type&>(from), write);                                  \
    json["__type"] = #Type;                                                               \
  }                                                                                       \
  inline void from_json(const nlohmann::json& json, Type& to) {                           \
    auto read = [&json](const char* name, auto* field) { json.at(name).get_to(*field); }; \
    _JsonTypeDefinition(to, read);                                                        \
  }                                                                                       \
  template <class AddField>                                                               \
  inline void _JsonTypeDefinition(Type& value, AddField& add_field)
