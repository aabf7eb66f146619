#include "behaviortree_cpp/json_export.h"

namespace BT {
namespace {

using Entry = JsonExporter::Entry;

template <class T>
Entry As(const nlohmann::json& json) {
  return {Any(json.get<T>()), TypeInfo::Create<T>()};
}

template <class T>
bool Put(const Any& any, nlohmann::json& json) {
  if (any.type() != typeid(T)) return false;
  json = any.cast<T>();
  return true;
}

// Of what JSON itself knows; the list if it is one.
template <class T>
Entry AsOneOrList(const nlohmann::json& json, bool is_list) {
  return is_list ? As<std::vector<T>>(json) : As<T>(json);
}

nonstd::unexpected_type<std::string> Unknown() {
  return nonstd::make_unexpected(std::string("Type not found in registered list"));
}

}  // namespace

JsonExporter& JsonExporter::get() {
  static JsonExporter exporter;
  return exporter;
}

bool JsonExporter::toJson(const Any& any, nlohmann::json& destination) const {
  if (any.empty()) return false;
  if (any.isString()) {
    destination = any.cast<std::string>();
  } else if (any.castedType() == typeid(std::int64_t)) {
    destination = any.cast<std::int64_t>();
  } else if (any.castedType() == typeid(std::uint64_t)) {
    destination = any.cast<std::uint64_t>();
  } else if (any.castedType() == typeid(double)) {
    destination = any.cast<double>();
  } else if (!Put<std::vector<double>>(any, destination) &&
             !Put<std::vector<int>>(any, destination) &&
             !Put<std::vector<bool>>(any, destination) &&
             !Put<std::vector<std::string>>(any, destination)) {
    const auto writer = writers_.find(any.type());
    if (writer == writers_.end()) return false;
    writer->second(any, destination);
  }
  return true;
}

JsonExporter::ExpectedEntry JsonExporter::fromJson(const nlohmann::json& source) const {
  if (source.is_null()) return Entry{Any(), TypeInfo::Create<std::nullptr_t>()};
  const bool is_list = source.is_array();
  if (is_list && source.empty()) {
    return nonstd::make_unexpected("Missing field '__type'");
  }
  const nlohmann::json& first = is_list ? source[0] : source;
  if (first.is_string()) return AsOneOrList<std::string>(source, is_list);
  if (first.is_number_integer()) return AsOneOrList<int>(source, is_list);
  if (first.is_number_float()) return AsOneOrList<double>(source, is_list);
  if (first.is_boolean()) return AsOneOrList<bool>(source, is_list);
  if (!first.is_object() || !first.contains("__type") || !first["__type"].is_string()) {
    return nonstd::make_unexpected("Missing field '__type'");
  }
  const auto type = types_.find(first["__type"].get<std::string>());
  if (type == types_.end()) return Unknown();
  const auto& readers = is_list ? list_readers_ : readers_;
  const auto reader = readers.find(type->second.type());
  if (reader == readers.end()) return Unknown();
  return reader->second(source);
}

JsonExporter::ExpectedEntry JsonExporter::fromJson(const nlohmann::json& source,
                                                   std::type_index type) const {
  const auto reader = readers_.find(type);
  if (reader == readers_.end()) return Unknown();
  return reader->second(source);
}

Any convertFromJSON(StringView json, std::type_index type) {
  const auto parsed = nlohmann::json::parse(json);
  const auto entry = JsonExporter::get().fromJson(parsed, type);
  if (!entry) throw RuntimeError(entry.error());
  return entry->first;
}

Expected<std::string> toJsonString(const Any& value) {
  nlohmann::json json;
  if (!JsonExporter::get().toJson(value, json)) {
    return nonstd::make_unexpected("toJsonString failed");
  }
  return StrCat("json:", json.dump());
}

}  // namespace BT
