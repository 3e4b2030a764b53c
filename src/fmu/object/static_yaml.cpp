// Debian's static yaml-cpp is compiled for programs: it expects this flag of the C library at a fixed distance, which a
// shared object has only for what it defines itself. 0 says that there may be several threads, which is always safe.
extern "C" {
__attribute__((visibility("hidden"))) char __libc_single_threaded = 0;
}
