// A glTF file taken apart and checked before tinygltf sees it: sentences instead of crashes for what is wrong
// with it.
#pragma once

#include "core/base/json/Json.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace taa {

/// A file beside the scene.
struct GltfFile {
  std::string name; ///< as the scene has it
  std::filesystem::path path;
};

struct GltfDocument {
  Json json;
  std::string binary;                   ///< the BIN chunk of a .glb
  bool isBinary = false;                ///< a .glb
  std::filesystem::path folder;         ///< where the files lie that it names
  std::vector<std::string> imageFaults; ///< for each image why it cannot be shown; empty: nothing is known
  std::vector<GltfFile> files;          ///< that it names: a uri is an index of this, as text
  std::vector<std::string> notes;       ///< to say of the file
};

// All of these throw Error with "place: reason"; the loader puts the file's name before it.

/// Reads and parses the file, and makes sure that it is glTF 2.0 that needs no extension unknown here.
GltfDocument readGltfDocument(const std::filesystem::path& file);

/// The type of every property and the range of every index, from one table.
void checkGltfTypes(const Json& root);

/// Buffers (which get their real lengths), views and accessors: everything lies inside what holds it. An
/// image that does not, or that is not there, has a fault instead.
void checkGltfData(GltfDocument& document);

/// Nodes are trees, scenes list their roots, animations refer to their own samplers.
void checkGltfGraph(const Json& root);

/// Takes out what nobody here reads: extras and unknown extensions.
void stripGltf(Json& root);

/// Whether `name` is an extension the loader understands.
bool isKnownGltfExtension(const std::string& name);

/// The bytes of a file; the Error has the reason only.
std::string readGltfFile(const std::filesystem::path& file, std::uintmax_t maxBytes);

/// Bytes of the regular file below the folder of the scene, once links are resolved, that `uri`
/// names; from now on it names its index in `files`. Throws Error when there is none.
std::uint64_t takeGltfFile(GltfDocument& document, Json& uri);

} // namespace taa
