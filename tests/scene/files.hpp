// Files for the tests of scenes: a folder of their own, and glTF models put together from arrays.
#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>

#include <passgraph/scene/scene_file.hpp>

namespace passgraph::test {

/// A folder that goes when the test ends.
class Folder {
public:
    Folder()
        : path_(std::filesystem::temp_directory_path() / fmt::format("passgraph_scene_{}_{}", getpid(), count()++))
    {
        std::filesystem::create_directories(path_);
    }
    ~Folder()
    {
        std::error_code code;
        std::filesystem::remove_all(path_, code);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string write(const std::string& name, std::string_view text) const
    {
        const auto path = path_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::filesystem::remove(path); // ext4 waits for the disk where a file is emptied and written again
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }
    std::string path(const std::string& name) const { return (path_ / name).string(); }

private:
    static int& count()
    {
        static int folders = 0;
        return folders;
    }
    std::filesystem::path path_;
};

inline std::string data_file(const std::string& name)
{
    return std::string(PASSGRAPH_SOURCE_DIR) + "/tests/data/" + name;
}

template <class T>
std::string bytes_of(const std::vector<T>& values)
{
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// Writes model.gltf beside model.bin: `rest` is the JSON after "asset", "buffers", "bufferViews" and "accessors".
class ModelBuilder {
public:
    /// Adds an accessor and gives its index. `more` is further JSON such as `,"normalized":true`.
    int add(const std::string& bytes, int component_type, size_t count, const std::string& type,
            const std::string& more = "")
    {
        views_ += fmt::format("{}{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}}}", views_.empty() ? "" : ",",
                              bytes_.size(), bytes.size());
        accessors_ += fmt::format("{}{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"{}}}",
                                  accessors_.empty() ? "" : ",", count_, component_type, count, type, more);
        bytes_ += bytes;
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        return count_++;
    }
    int add_floats(const std::vector<float>& values, size_t components)
    {
        return add(bytes_of(values), 5126, values.size() / components,
                   components == 1 ? "SCALAR" : fmt::format("VEC{}", components));
    }

    std::string write(const Folder& folder, const std::string& rest) const
    {
        folder.write("model.bin", bytes_);
        return folder.write("model.gltf",
                            fmt::format("{{\"asset\":{{\"version\":\"2.0\"}},\"buffers\":[{{\"byteLength\":{},\"uri\":"
                                        "\"model.bin\"}}],\"bufferViews\":[{}],\"accessors\":[{}],{}}}",
                                        bytes_.size(), views_, accessors_, rest));
    }

private:
    std::string bytes_;
    std::string views_;
    std::string accessors_;
    int count_ = 0;
};

/// The scene of one model, or its mistakes as text.
struct Loaded {
    Scene scene;
    std::string mistakes;
};

inline Loaded load_model(const std::string& path, const glm::mat4& placed = glm::mat4(1.0f))
{
    Loaded loaded;
    if (const auto done = append_gltf(loaded.scene, path, placed, "thing"); !done)
        loaded.mistakes = to_text(done.error());
    return loaded;
}

/// One mesh of one triangle in the plane z = 0, seen from +Z.
inline const std::vector<float> kTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

/// "scene"-less JSON of one node with one primitive.
inline std::string one_mesh(const std::string& primitive, const std::string& more = "")
{
    return fmt::format("\"nodes\":[{{\"mesh\":0}}],\"meshes\":[{{\"primitives\":[{{{}}}]}}]{}", primitive, more);
}

} // namespace passgraph::test
