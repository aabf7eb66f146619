// Shared libraries that are loaded by name.
#pragma once

#include <string>

namespace BT {

class SharedLibrary {
 public:
  SharedLibrary() = default;
  /// Throws RuntimeError if it cannot be loaded. It stays loaded.
  explicit SharedLibrary(const std::string& path, int flags = 0) { load(path, flags); }
  void load(const std::string& path, int flags = 0);
  void unload();
  bool isLoaded() const { return handle_ != nullptr; }
  bool hasSymbol(const std::string& name) { return findSymbol(name) != nullptr; }
  /// Throws RuntimeError if the library has none of that name.
  void* getSymbol(const std::string& name);
  const std::string& getPath() const { return path_; }
  static std::string prefix() { return "lib"; }
  static std::string suffix() { return ".so"; }
  /// "lib" NAME ".so"
  static std::string getOSName(const std::string& name) { return prefix() + name + suffix(); }

 private:
  void* findSymbol(const std::string& name);

  std::string path_;
  void* handle_ = nullptr;
};

}  // namespace BT
