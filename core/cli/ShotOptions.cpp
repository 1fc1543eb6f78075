#include "core/cli/ShotOptions.h"

#include "core/replay/Checkpoints.h"
#include "core/scene/SceneCost.h"

#include <CLI/CLI.hpp>

namespace taa::cli {

namespace {

/// Returns that of the camera.
CLI::Option* addSceneOptions(CLI::App& command, ShotArguments& shot) {
  CLI::Option* camera =
      command.add_option("--camera", shot.camera,
                         "still, pan, orbit, dolly or gltf:NAME; else the scene's own. A captured "
                         "sequence has no other than that it was taken with");
  CLI::Option* pose =
      command
          .add_option("--camera-pose", shot.cameraPose,
                      "x,y,z,yaw,pitch or with the field of view after them: a camera that rests there; "
                      "degrees, yaw 0 looks along -z")
          ->excludes(camera);
  command.add_option("--camera-path", shot.cameraPath, "A .json file with a pose for each frame")
      ->type_name("FILE")
      ->excludes(camera)
      ->excludes(pose);
  command.add_option("--animation", shot.choice.animation,
                     "Of a file with several: the one that plays, by its name, or all; else the first");
  command
      .add_option("--length", shot.choice.frames,
                  "How many frames the shot has, 1 to 100000; else as many as the scene's own")
      ->check(CLI::Range(1, kMaxShotFrames));
  command
      .add_option("--hide", shot.filter.hidden,
                  "Do not draw the objects of this name and what is below them; repeat it for more")
      ->allow_extra_args(false);
  command
      .add_option("--isolate", shot.filter.isolated,
                  "Draw only the objects of this name and what is below them; repeat it for more")
      ->allow_extra_args(false);
  command
      .add_option(
          "--motion-mode", shot.motionModes,
          "NODE=MODE: motion of the objects of this name; perObject, cameraOnly or none; repeat it for "
          "more")
      ->allow_extra_args(false);
  command
      .add_option("--class", shot.classes,
                  "OBJECT=CLASS: class of the objects of this name and of what is below them; still, moving, "
                  "deforming or character; repeat it for more")
      ->allow_extra_args(false);
  command
      .add_option("--restart", shot.restarts,
                  "A frame at which history starts anew, as after a cut; repeat it for more")
      ->check(CLI::Range(0, kMaxShotFrames - 1))
      ->allow_extra_args(false);
  return camera;
}

} // namespace

void addShotOptions(CLI::App& command, ShotArguments& shot) {
  CLI::Option* source =
      command.add_option("SOURCE", shot.source,
                         "A glTF file (.gltf, .glb), the folder or capture.json of a captured sequence, or "
                         "builtin:NAME (see list scenes)");
  CLI::Option* size =
      command.add_option("--size", shot.size,
                         "Size of the picture, WxH pixels; else " + std::string(kDefaultSize) +
                             ", and of a captured sequence its own, which is the only one it has");
  CLI::Option* camera = addSceneOptions(command, shot);
  CLI::Option* preset =
      command.add_option("--preset", shot.preset, "A preset (see list presets) or a .json file")
          ->capture_default_str();
  CLI::Option* lane =
      command
          .add_option("--lane", shot.lanes, "A preset; repeat it to run up to five side by side, as A to E")
          ->allow_extra_args(false)
          ->excludes(preset);
  CLI::Option* session = command.add_option(
      "--session", shot.session,
      "A session of taa-inspector (.taa.json): its scene, camera, frame, size and settings");
  for (CLI::Option* instead : {source, size, camera, preset, lane}) session->excludes(instead);
  command.add_option("--checkpoints", shot.checkpointsMiB, "Memory for the histories that are kept, MiB")
      ->check(CLI::Range(0, kMaxCheckpointMiB))
      ->capture_default_str();
  addSceneBudget(command, shot.sceneMillions, shot.sceneMiB);
  command
      .add_option(
          "--set", shot.assignments,
          "path=value (see list parameters), or motion.NODE=MODE (see --motion-mode); repeat it for more")
      ->allow_extra_args(false);
}

void addSceneBudget(CLI::App& command, int& millions, int& mib) {
  command
      .add_option("--scene-triangles", millions,
                  "Triangles that a scene may draw, its instances counted, millions; one with more is not "
                  "opened")
      ->check(CLI::Range(1, kMaxSceneMillions))
      ->capture_default_str();
  command.add_option("--scene-memory", mib, "Memory for the buffers and textures of a scene, MiB")
      ->check(CLI::Range(1, kMaxSceneMiB))
      ->capture_default_str();
}

void addForce(CLI::App& command, bool& force) {
  command.add_flag("--force", force,
                   "Replace files that are there; without it they are left and nothing is done");
}

void addReferenceSamples(CLI::App& command, int& samples, const std::string& what) {
  command.add_option("--reference-samples", samples, "Samples in a pixel " + what)->capture_default_str();
}

} // namespace taa::cli
