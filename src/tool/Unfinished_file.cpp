// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Unfinished_file.h"

#include <cerrno>
#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

namespace bounding_arcs_tool {
namespace {

#ifdef O_PATH
constexpr int FOLDER = O_PATH | O_DIRECTORY | O_CLOEXEC;  // a folder in which one may write need not be readable
#else
constexpr int FOLDER = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
#endif

// What is to be removed when a signal ends the program: a name in an open folder. Names given by users may be as long
// as the file system takes, so this is not made of them.
char unfinished[64] = "";
volatile std::sig_atomic_t folder_of_unfinished = -1;

extern "C" void remove_unfinished(int signal) {
  if (folder_of_unfinished >= 0) ::unlinkat(folder_of_unfinished, unfinished, 0);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

bool ends_nothing(int signal) {
  switch (signal) {
    case SIGCHLD:
    case SIGCONT:
    case SIGSTOP:
    case SIGTSTP:
    case SIGTTIN:
    case SIGTTOU:
    case SIGURG:
    case SIGWINCH:
      return true;
    default:
      return false;
  }
}

// Sets the handler wherever a signal would end the program: not for those that who started this, or a sanitizer, wants
// otherwise.
void remove_at_signals() {
  for (int signal = 1; signal < NSIG; ++signal) {
    struct sigaction action {};
    if (ends_nothing(signal) || ::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action = {};
    action.sa_handler = remove_unfinished;
    (void)::sigaction(signal, &action, nullptr);  // fails for SIGKILL
  }
}

// A new file under a name that nothing has yet: an earlier run of the same process number may have been killed.
int create(int folder, mode_t mode) {
  constexpr int TRIES = 100;
  for (int i = 0; i < TRIES; ++i) {
    std::snprintf(unfinished, sizeof unfinished, "bounding_arcs-%ld-%d.part", static_cast<long>(::getpid()), i);
    const int descriptor = ::openat(folder, unfinished, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

// Nobody reads the new file who could not read the old one: the mode comes last.
void take_over(int descriptor, const struct stat& old) {
  constexpr mode_t PERMISSIONS = 0777;
  constexpr uid_t SAME_OWNER = static_cast<uid_t>(-1);
  // Only the superuser gives files away; others may have the group in common, or else keep their own.
  const bool is_owned_alike =
      ::fchown(descriptor, old.st_uid, old.st_gid) == 0 || ::fchown(descriptor, SAME_OWNER, old.st_gid) == 0;
  (void)is_owned_alike;
  (void)::fchmod(descriptor, old.st_mode & PERMISSIONS);
}

}  // namespace

Unfinished_file::Unfinished_file(const std::string& folder, const struct stat* old)
    : folder_(::open(folder.c_str(), FOLDER)) {
  constexpr mode_t NEW = 0666, PRIVATE = 0600;
  if (folder_ < 0) return;
  remove_at_signals();
  sigset_t all, before;  // no signal comes between making the file and knowing that it is to be removed
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  descriptor_ = create(folder_, old == nullptr ? NEW : PRIVATE);
  const int cause = errno;
  if (descriptor_ >= 0) folder_of_unfinished = folder_;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = cause;
  if (descriptor_ >= 0 && old != nullptr) take_over(descriptor_, *old);
}

Unfinished_file::~Unfinished_file() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (folder_of_unfinished >= 0) ::unlinkat(folder_, unfinished, 0);
  folder_of_unfinished = -1;
  if (folder_ >= 0) ::close(folder_);
}

bool Unfinished_file::rename_to(const std::string& name) {
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0 || ::renameat(folder_, unfinished, folder_, name.c_str()) != 0) return false;
  folder_of_unfinished = -1;
  return true;
}

}  // namespace bounding_arcs_tool
