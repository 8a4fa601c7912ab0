#ifndef ISR_RECONSTRUCT_OUTPUT_FILE_H
#define ISR_RECONSTRUCT_OUTPUT_FILE_H

#include "exit_status.h"
#include "interruption.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <string>
#include <system_error>

#include <unistd.h>

namespace isr {

// A file that appears under its name when it is complete, or not at all: it is written under a
// temporary name in the same directory, so that renaming it is atomic.
class Output_file
{
public:
  explicit Output_file(const std::filesystem::path& path)
    : m_path(path), m_temporary(temporary_path(path)), m_stream(&m_buffer)
  {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
      throw Failure(UNWRITABLE_OUTPUT, "cannot write '" + path.string() + "': not a regular file");
    errno = 0;
    if (!m_buffer.open(m_temporary, std::ios::out | std::ios::trunc | std::ios::binary))
      fail();
    m_stream.exceptions(std::ios::goodbit);
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    std::error_code ignored;
    m_buffer.close();
    if (!m_committed)
      std::filesystem::remove(m_temporary, ignored);
  }

  const std::filesystem::path& path() const { return m_path; }
  std::ostream& stream() { return m_stream; }

  // Writes what is buffered; the file keeps its temporary name.
  void finish()
  {
    m_stream.flush();
    const bool closed = m_buffer.close() != nullptr;
    throw_if_interrupted();
    if (!m_stream || !closed)
      fail();
  }

  // Gives the finished file its name.
  void commit()
  {
    std::error_code error;
    std::filesystem::rename(m_temporary, m_path, error);
    if (error)
      throw Failure(UNWRITABLE_OUTPUT, "cannot write '" + m_path.string() + "': " + error.message());
    m_committed = true;
  }

private:
  static std::filesystem::path temporary_path(const std::filesystem::path& path)
  {
    const std::string name = "." + path.filename().string() + "." + std::to_string(getpid());
    return path.parent_path() / name;
  }

  [[noreturn]] void fail() const
  {
    const std::string reason = errno != 0 ? std::strerror(errno) : "write error";
    throw Failure(UNWRITABLE_OUTPUT, "cannot write '" + m_path.string() + "': " + reason);
  }

  std::filesystem::path m_path, m_temporary;
  Interruptible_filebuf m_buffer;
  std::ostream m_stream;
  bool m_committed = false;
};

} // namespace isr

#endif // ISR_RECONSTRUCT_OUTPUT_FILE_H
