// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/animation.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

#include "tensortopo/analysis/mode_range.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/temporary_folder.hpp"
#include "tensortopo/io/write_text.hpp"

namespace tensortopo {
namespace {

constexpr std::size_t kMostFrames = 10000;
constexpr int kEncoderNotStarted = 127;

// The child: becomes ffmpeg, which reads PNG files from `input`, one after the other.
[[noreturn]] void become_ffmpeg(int input, const std::filesystem::path& file) {
  dup2(input, STDIN_FILENO);
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  std::vector<std::string> words{"ffmpeg", "-y", "-f", "image2pipe", "-c:v",
                                 "png",    "-r", "12", "-i",         "-"};
  if (lower_extension(file) == ".gif") {
    // One palette for all frames; grains between its colours would only make the file larger.
    words.insert(words.end(),
                 {"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none"});
  } else {
    words.insert(words.end(), {"-pix_fmt", "yuv420p", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2"});
  }
  // A path that looks like an option or a protocol is none.
  words.push_back("file:" + file.string());
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp("ffmpeg", arguments.data());
  _exit(kEncoderNotStarted);
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

std::vector<ModeValue> parse_animation(std::string_view text) {
  return parse_mode_range("--animate", text, kMostFrames);
}

std::filesystem::path frame_file(const std::filesystem::path& picture, std::size_t frame,
                                 std::size_t count) {
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(count - 1).size());
  std::filesystem::path file = picture;
  file.replace_filename(fmt::format("{}-{:0{}}.png", picture.stem().string(), frame, digits));
  return file;
}

bool is_film(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".gif" || extension == ".mp4";
}

void require_ffmpeg(const std::filesystem::path& file) {
  const char* const folders = std::getenv("PATH");
  for (std::string_view rest = folders == nullptr ? "" : folders; !rest.empty();) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const auto program = std::filesystem::path(rest.substr(0, end)) / "ffmpeg";
    std::error_code ignored;
    if (std::filesystem::is_regular_file(program, ignored) && access(program.c_str(), X_OK) == 0)
      return;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  throw IoError(IoError::Kind::unwritable, file,
                "films need the program ffmpeg (Debian package ffmpeg); nothing is drawn. With "
                "-o FILE.png there are the frames alone");
}

std::size_t write_film(const std::filesystem::path& file,
                       const std::vector<std::string>& pictures) {
  const auto fail = [&](const std::string& why) {
    throw IoError(IoError::Kind::unwritable, file, why);
  };
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail("cannot make a pipe for ffmpeg");
  TemporaryFolder folder;
  const std::filesystem::path made = folder.file(file.filename());
  const pid_t child = fork();
  if (child == 0) become_ffmpeg(ends[0], made);
  close(ends[0]);
  if (child < 0) {
    close(ends[1]);
    fail("cannot start ffmpeg");
  }
  // A child that ends early is told by its status, not by a signal.
  struct sigaction ignore {
  }, before{};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, &before);
  bool whole = true;
  for (const std::string& picture : pictures) whole = whole && write_all(ends[1], picture);
  close(ends[1]);
  sigaction(SIGPIPE, &before, nullptr);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == kEncoderNotStarted)
    fail("cannot start ffmpeg; nothing is written");
  if (!whole || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    fail("ffmpeg makes no film of the frames; nothing is written");
  std::ifstream film(made, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(film), {}};
  if (!film) fail("the film that ffmpeg made cannot be read");
  write_text(file, bytes);
  return bytes.size();
}

}  // namespace tensortopo
