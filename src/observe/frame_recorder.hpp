#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "io/frames.hpp"
#include "observe/observer.hpp"

namespace tt {

/// All of one step in SI, as frames.h5 keeps it.
Frame frame_of(const Snapshot& snapshot);
/// The same without the fields.
Frame membranes_of(const Snapshot& snapshot);

/// frames.h5: nodes, their forces and velocities, and the fields of velocity, pressure and
/// cytoplasm.
class FrameRecorder : public Observer {
public:
    /// `fields`: a frame holds the fields if this is due since the one before; nothing: none does.
    /// `say` takes a message for the log.
    FrameRecorder(const Schedule& schedule, std::optional<Schedule> fields,
                  const std::filesystem::path& directory, FramesHeader header,
                  std::function<void(const std::string&)> say);

    void start() override;
    void resume(const ArchiveReader& archive) override;
    void observe(const Snapshot& snapshot) override;
    void sync() override;
    void save(ArchiveOutput& archive) const override;
    void finish() override;

    /// DamagedArchive if what was saved cannot be of a run.
    static void examine(const ArchiveReader& archive);

private:
    bool fields_due(std::int64_t step) const;

    std::optional<Schedule> fields_;
    std::filesystem::path directory_;
    FramesHeader header_;
    std::function<void(const std::string&)> say_;
    std::optional<FramesWriter> writer_;
};

/// What the frames of a run share.
FramesHeader frames_header(const Model& model, const State& state, const std::string& name);

}  // namespace tt
