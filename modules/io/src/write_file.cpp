// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/io/write_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <locale>

namespace pointmill {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const char* what)
{
  const std::string reason = std::strerror(errno);
  throw DataError(path + ": " + what + " (" + reason +
                  "); check the folder, its permissions and the free space");
}

// The file that the name stands for. Renaming onto a device or a link would replace it.
std::string targetOf(const std::string& path)
{
  std::error_code error;
  const auto status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw DataError(path + ": is not a file; name the file to write");
  if (fs::is_symlink(fs::symlink_status(path, error)) && fs::exists(status))
    return fs::canonical(path).string();
  return path;
}

/// A new file that is gone again unless it was renamed.
class TemporaryFile {
public:
  explicit TemporaryFile(const std::string& target)
  {
    static std::atomic<unsigned> count{0};
    do {
      name_ = target + "." + std::to_string(::getpid()) + "-" +
              std::to_string(count++) + ".part";
      descriptor_ =
          ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0)
      fail(target, "cannot be written");
  }
  ~TemporaryFile()
  {
    ::close(descriptor_);
    if (!renamed_)
      ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& name() const { return name_; }
  void rename(const std::string& target)
  {
    // Or a crash soon after could leave the new name with no content.
    if (::fsync(descriptor_) != 0)
      fail(target, "cannot be written to its end");
    if (::rename(name_.c_str(), target.c_str()) != 0)
      fail(target, "cannot be replaced");
    renamed_ = true;
  }

private:
  std::string name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

} // namespace

void writeFileAtomically(const std::string& path,
                         const std::function<void(std::ostream&)>& body)
{
  const std::string target = targetOf(path);
  TemporaryFile file(target);
  std::ofstream out(file.name(), std::ios::binary);
  out.imbue(std::locale::classic());
  try {
    body(out);
  }
  catch (const Error&) {
    throw;
  }
  catch (const std::exception& e) {
    throw DataError(path + ": writing it failed: " + e.what());
  }
  out.close();
  if (!out)
    fail(path, "cannot be written to its end");
  file.rename(target);
}

} // namespace pointmill
