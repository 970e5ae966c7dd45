// The pipe to a host and the session behind it, for any event loop; and the plain loop.
#pragma once

#include "service/session.h"

namespace service {

// Whoever runs the loop calls receive() when the input is readable or at its end, flush() when the
// output can take more and sending(), and attend() when the session's descriptor is readable or
// its deadline has come; until it is closed.
class Connection {
public:
    Connection(Platform platform, int input, int output);

    void receive(); // reads what came, serves it, and attends
    void attend();
    void flush();
    [[nodiscard]] bool sending() const { return !channel_.outgoing().empty(); }
    // The host said exit, its end of the pipe is closed, or it sent what is not the protocol.
    [[nodiscard]] bool closed() const;
    // Of the process, once closed. What was not the protocol is said on standard error.
    [[nodiscard]] int exitCode() const;

    [[nodiscard]] int input() const { return input_; }
    [[nodiscard]] int output() const { return output_; }
    [[nodiscard]] Session& session() { return session_; }
    [[nodiscard]] ipc::MediumChannel& channel() { return channel_; }

private:
    int input_, output_;
    bool open_ = true;
    ipc::MediumChannel channel_;
    Session session_;
};

// Serves until the connection is closed, or `until` holds after something happened.
void serve(Connection& connection, const std::function<bool()>& until);

} // namespace service
