// drop_file WINDOW FILE: drops a file on an X11 window as a file manager does (XDND protocol, version 5), without a
// mouse. Exit status 0 when the window took it.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

namespace {

class Source {
public:
    Source(Display *display, Window target, std::string uri) : display_(display), target_(target), uri_(std::move(uri)) {
        window_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
    }

    bool drop() {
        constexpr long version = 5;
        send("XdndEnter", version << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
        send("XdndPosition", 0, (400L << 16) | 300L, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
        const XClientMessageEvent status = answer("XdndStatus");
        if ((status.data.l[1] & 1) == 0)
            return false; // not wanted there
        send("XdndDrop", 0, CurrentTime, 0, 0);
        // The protocol asks for bit 0 only; GLFW 3.3 puts the number of bytes there.
        return answer("XdndFinished").data.l[1] != 0;
    }

private:
    Atom atom(const char *name) const { return XInternAtom(display_, name, False); }

    void send(const char *type, long b, long c, long d, long e) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.display = display_;
        event.xclient.window = target_;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        const long data[] = {static_cast<long>(window_), b, c, d, e};
        for (int i = 0; i < 5; ++i)
            event.xclient.data.l[i] = data[i];
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Serves the dropped name to whoever asks for it until the answer of this type comes.
    XClientMessageEvent answer(const char *type) {
        const std::time_t end = std::time(nullptr) + 10;
        while (std::time(nullptr) < end) {
            if (XPending(display_) == 0) {
                const timespec nap{0, 10'000'000};
                nanosleep(&nap, nullptr);
                continue;
            }
            XEvent event;
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest)
                serve(event.xselectionrequest);
            if (event.type == ClientMessage && event.xclient.message_type == atom(type))
                return event.xclient;
        }
        std::fprintf(stderr, "no %s came\n", type);
        std::exit(1);
    }

    void serve(const XSelectionRequestEvent &request) {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char *>(uri_.data()), static_cast<int>(uri_.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    Display *display_;
    Window target_, window_;
    std::string uri_;
};

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: drop_file WINDOW FILE\n");
        return 2;
    }
    Display *display = XOpenDisplay(nullptr);
    if (!display) {
        std::fprintf(stderr, "no display\n");
        return 1;
    }
    Source source(display, std::strtoul(argv[1], nullptr, 0), "file://" + std::string(argv[2]) + "\r\n");
    const bool taken = source.drop();
    XCloseDisplay(display);
    return taken ? 0 : 1;
}
