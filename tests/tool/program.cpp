// A process with its output in files, and the files beside them.
#include "program.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <passgraph/image/image_file.hpp>

#include "support/catch.hpp"

namespace passgraph::test {

namespace fs = std::filesystem;

Workplace::Workplace()
{
    static int count = 0;
    folder_ = (fs::temp_directory_path() / ("passgraph_tool_" + std::to_string(::getpid()) + "_" + std::to_string(count++))).string();
    fs::create_directories(folder_ + "/work");
    folder_ += "/work";
}

Workplace::~Workplace() { fs::remove_all(fs::path(folder_).parent_path()); }

Outcome Workplace::run(const std::vector<std::string>& words, const std::string& setting) const
{
    const std::string out = folder_ + "/../stdout";
    const std::string err = folder_ + "/../stderr";
    std::vector<std::string> argv = {PASSGRAPH_PROGRAM};
    argv.insert(argv.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& word : argv)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        const size_t equals = setting.find('=');
        if (equals != std::string::npos)
            ::setenv(setting.substr(0, equals).c_str(), setting.substr(equals + 1).c_str(), 1);
        const int to_out = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const int to_err = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (to_out < 0 || to_err < 0 || ::dup2(to_out, 1) < 0 || ::dup2(to_err, 2) < 0 || ::chdir(folder_.c_str()) != 0)
            ::_exit(126);
        ::execv(PASSGRAPH_PROGRAM, pointers.data());
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("../stdout"), read("../stderr")};
}

void Workplace::write(const std::string& name, const std::string& text) const
{
    fs::create_directories(fs::path(path(name)).parent_path());
    std::ofstream file(path(name), std::ios::binary);
    file << text;
    file.close();
    REQUIRE(file.good());
}

void Workplace::write_picture(const std::string& name, const Picture& picture) const
{
    REQUIRE(passgraph::write_picture(path(name), picture));
}

std::string Workplace::read(const std::string& name) const
{
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Picture Workplace::read_picture(const std::string& name) const
{
    auto picture = passgraph::read_picture(path(name), Transfer::as_is);
    INFO(name);
    REQUIRE(picture);
    return *picture;
}

bool Workplace::has(const std::string& name) const { return fs::exists(path(name)); }

std::vector<std::string> Workplace::files() const
{
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
        if (entry.is_regular_file())
            names.push_back(fs::relative(entry.path(), folder_).string());
    std::sort(names.begin(), names.end());
    return names;
}

Picture flat(Extent extent, std::vector<float> value)
{
    Picture picture(extent, static_cast<int>(value.size()));
    for (size_t i = 0; i < picture.texels.size(); ++i)
        picture.texels[i] = value[i % value.size()];
    return picture;
}

std::string tone_map_graph()
{
    return R"({
  "passgraph": 1,
  "inputs": { "image": "radiance" },
  "passes": {
    "bright_part": { "pass": "bright", "inputs": { "image": "image" }, "params": { "threshold": 0 } },
    "shown": { "pass": "tone_map", "inputs": { "image": "bright_part" } }
  },
  "params": { "brightness": "shown.exposure" },
  "outputs": { "color": "shown" }
}
)";
}

Json json_of(const std::string& text)
{
    INFO(text);
    auto json = parse_json(text, "out.json");
    REQUIRE(json);
    return *json;
}

} // namespace passgraph::test
