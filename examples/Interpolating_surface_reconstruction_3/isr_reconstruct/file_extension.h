#ifndef ISR_RECONSTRUCT_FILE_EXTENSION_H
#define ISR_RECONSTRUCT_FILE_EXTENSION_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace isr {

// The extension in lower case, with the dot.
inline std::string file_extension(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

} // namespace isr

#endif // ISR_RECONSTRUCT_FILE_EXTENSION_H
