// Module of controllers: all code that uses liblo and RtMidi.
#include "render/failure.h"
#include "ui/controllers/control_input.h"

#include <RtMidi.h>
#include <lo/lo.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr std::size_t mostAtOnce = 256;    // Messages of one call of `read`.
constexpr std::size_t mostWaiting = 4096;  // MIDI messages that wait; further ones are dropped.

/// Last error of liblo in this thread: its handler gets no pointer to the caller.
thread_local std::string oscError;

void keepOscError(int, const char* why, const char*)
{
    oscError = why ? why : "";
}

/// Reads the numeric arguments of an OSC message.
std::vector<double> numbersOf(const char* types, lo_arg** arguments, int count)
{
    std::vector<double> numbers;
    for (int i = 0; i < count; ++i) {
        const auto type = static_cast<lo_type>(types[i]);
        if (type == LO_TRUE || type == LO_FALSE)
            numbers.push_back(type == LO_TRUE ? 1 : 0);
        else if (lo_is_numerical_type(type))
            numbers.push_back(static_cast<double>(lo_hires_val(type, arguments[i])));
    }
    return numbers;
}

class OscInput final : public ControlInput {
public:
    explicit OscInput(int port)
    {
        oscError.clear();
        server_ = lo_server_new_with_proto(std::to_string(port).c_str(), LO_UDP, keepOscError);
        if (!server_)
            throw Failure(ErrorKind::file,
                          message("Cannot listen to OSC at port {1}: {2}. Choose another port in Edit > Preferences > "
                                  "Controllers.",
                                  std::to_string(port),
                                  Message::verbatim(oscError.empty() ? "the port cannot be opened" : oscError)));
        lo_server_enable_queue(server_, 0, 1);  // Bundles for later are carried out now.
        lo_server_add_method(server_, nullptr, nullptr, take, this);
    }
    ~OscInput() override { lo_server_free(server_); }
    OscInput(const OscInput&) = delete;
    OscInput& operator=(const OscInput&) = delete;

    int descriptor() const override { return lo_server_get_socket_fd(server_); }
    std::vector<ControlMessage> read() override
    {
        while (messages_.size() < mostAtOnce && lo_server_recv_noblock(server_, 0) > 0) {
        }
        return std::exchange(messages_, {});
    }
    std::vector<std::string> devices() override { return {}; }

private:
    static int take(const char* path, const char* types, lo_arg** arguments, int count, lo_message, void* input)
    {
        if (path) static_cast<OscInput*>(input)->messages_.push_back({path, numbersOf(types, arguments, count), {}});
        return 0;
    }

    lo_server server_ = nullptr;
    std::vector<ControlMessage> messages_;
};

/// All MIDI inputs of the ALSA sequencer. Each device has a thread of RtMidi, which puts messages into a queue.
class MidiInput final : public ControlInput {
public:
    MidiInput() : waiting_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK))
    {
        try {
            probe_ = std::make_unique<RtMidiIn>(RtMidi::LINUX_ALSA, "Vitrine");
        } catch (const RtMidiError& error) {
            ::close(waiting_);
            throw Failure(ErrorKind::file,
                          message("MIDI devices cannot be read: {1}. Load the ALSA sequencer (modprobe "
                                  "snd-seq), or switch MIDI off in Edit > Preferences > Controllers.",
                                  Message::verbatim(error.getMessage())));
        }
        probe_->setErrorCallback([](RtMidiError::Type, const std::string&, void*) {});
    }
    ~MidiInput() override
    {
        open_.clear();  // Ends the threads that use the queue.
        ::close(waiting_);
    }
    MidiInput(const MidiInput&) = delete;
    MidiInput& operator=(const MidiInput&) = delete;

    int descriptor() const override { return waiting_; }
    std::vector<ControlMessage> read() override
    {
        std::uint64_t count = 0;
        (void)!::read(waiting_, &count, sizeof count);
        const std::lock_guard lock(mutex_);
        return std::exchange(messages_, {});
    }
    std::vector<std::string> devices() override
    {
        std::vector<std::string> names;
        const unsigned int count = probe_->getPortCount();
        for (unsigned int port = 0; port < count; ++port) {
            std::string name = probe_->getPortName(port);
            // "Midi Through" repeats what programs send, and our own ports are no devices.
            if (name.empty() || name.rfind("Midi Through", 0) == 0 || name.rfind("Vitrine", 0) == 0) continue;
            if (isOpen(name) || open(port, name)) names.push_back(std::move(name));
        }
        std::erase_if(open_, [&](const auto& device) {
            return std::find(names.begin(), names.end(), device.first) == names.end();
        });
        return names;
    }

private:
    [[nodiscard]] bool isOpen(const std::string& name) const
    {
        return std::any_of(open_.begin(), open_.end(), [&](const auto& device) { return device.first == name; });
    }
    /// Opens a device. Returns false if that fails, for example because it was removed at this moment.
    bool open(unsigned int port, const std::string& name)
    {
        try {
            auto device = std::make_unique<RtMidiIn>(RtMidi::LINUX_ALSA, "Vitrine");
            device->setErrorCallback([](RtMidiError::Type, const std::string&, void*) {});
            device->setCallback(
                [](double, std::vector<unsigned char>* bytes, void* input) {
                    if (bytes) static_cast<MidiInput*>(input)->take(*bytes);
                },
                this);
            device->openPort(port, "controllers");
            open_.emplace_back(name, std::move(device));
            return true;
        } catch (const RtMidiError&) {
            return false;
        }
    }
    void take(const std::vector<unsigned char>& bytes)
    {
        {
            const std::lock_guard lock(mutex_);
            if (messages_.size() >= mostWaiting) return;
            messages_.push_back({{}, {}, bytes});
        }
        const std::uint64_t one = 1;
        (void)!::write(waiting_, &one, sizeof one);
    }

    int waiting_;
    std::mutex mutex_;
    std::vector<ControlMessage> messages_;
    std::unique_ptr<RtMidiIn> probe_;
    std::vector<std::pair<std::string, std::unique_ptr<RtMidiIn>>> open_;
};

}  // namespace
}  // namespace vitrine::ui

extern "C" __attribute__((visibility("default"))) vitrine::ui::ControlInput*
vitrineControllers(int version, vitrine::ui::ControlInputKind kind, int port)
{
    if (version != vitrine::ui::vitrineControllersVersion) return nullptr;
    if (kind == vitrine::ui::ControlInputKind::osc) return new vitrine::ui::OscInput(port);
    return new vitrine::ui::MidiInput;
}
