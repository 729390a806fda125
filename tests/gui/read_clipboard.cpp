// read_clipboard: prints what another program on this X11 display has put into the clipboard. Exit status 0 when there
// was text.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <cstdio>
#include <ctime>

int main() {
    Display *display = XOpenDisplay(nullptr);
    if (!display) {
        std::fprintf(stderr, "no display\n");
        return 1;
    }
    const Window window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
    const Atom text = XInternAtom(display, "UTF8_STRING", False), place = XInternAtom(display, "PENUMBRA_TEXT", False);
    XConvertSelection(display, XInternAtom(display, "CLIPBOARD", False), text, place, window, CurrentTime);
    XFlush(display);
    const std::time_t end = std::time(nullptr) + 50; // output_of() waits for a minute
    while (std::time(nullptr) < end) {
        if (XPending(display) == 0) {
            const timespec nap{0, 10'000'000};
            nanosleep(&nap, nullptr);
            continue;
        }
        XEvent event;
        XNextEvent(display, &event);
        if (event.type != SelectionNotify)
            continue;
        Atom type = None;
        int format = 0;
        unsigned long n = 0, left = 0;
        unsigned char *bytes = nullptr;
        if (event.xselection.property == None ||
            XGetWindowProperty(display, window, place, 0, 1 << 20, False, text, &type, &format, &n, &left, &bytes) !=
                Success ||
            type != text)
            break;
        std::fwrite(bytes, 1, n, stdout);
        XFree(bytes);
        XCloseDisplay(display);
        return 0;
    }
    std::fprintf(stderr, "there is no text in the clipboard\n");
    return 1;
}
