#include "agreement.hpp"

#include <fmt/format.h>

#include "tags.hpp"

namespace slidewave {

void Agreement::finish(MPI_Request& request, char const* what) const {
  waiter_.request(request, [&] { return std::string(what); });
}

void Agreement::sum_all(double* values, int count, char const* what) const {
  MPI_Request request;
  MPI_Iallreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, world_.all, &request);
  finish(request, what);
}

void Agreement::sum_side(double* values, int count, char const* what) const {
  MPI_Request request;
  MPI_Iallreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, world_.side, &request);
  finish(request, what);
}

void Agreement::max_side(double* values, int count, char const* what) const {
  MPI_Request request;
  MPI_Iallreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_MAX, world_.side, &request);
  finish(request, what);
}

void Agreement::share_on_side(std::string& text, char const* what) const {
  MPI_Request request;
  long size = static_cast<long>(text.size());
  MPI_Ibcast(&size, 1, MPI_LONG, 0, world_.side, &request);
  finish(request, what);
  text.resize(size);
  MPI_Ibcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, world_.side, &request);
  finish(request, what);
}

void Agreement::share_on_side(std::vector<double>& values, char const* what) const {
  MPI_Request request;
  long size = static_cast<long>(values.size());
  MPI_Ibcast(&size, 1, MPI_LONG, 0, world_.side, &request);
  finish(request, what);
  values.resize(size);
  MPI_Ibcast(values.data(), static_cast<int>(size), MPI_DOUBLE, 0, world_.side, &request);
  finish(request, what);
}

std::string Agreement::swap_between_roots(std::string const& text, char const* what) const {
  MPI_Request sent;
  MPI_Isend(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, tag::text, world_.inter,
            &sent);
  std::string answer = receive_text(what);
  finish(sent, what);
  return answer;
}

void Agreement::send_text(std::string const& text, char const* what) const {
  MPI_Request sent;
  MPI_Isend(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, tag::text, world_.inter,
            &sent);
  finish(sent, what);
}

std::string Agreement::receive_text(char const* what) const {
  MPI_Message message;
  MPI_Status status;
  waiter_.until(
      [&] {
        int found = 0;
        MPI_Improbe(0, tag::text, world_.inter, &found, &message, &status);
        return found != 0;
      },
      [&] { return fmt::format("{}: {}", name_of(other(role_)), what); });
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(size, ' ');
  MPI_Request received;
  MPI_Imrecv(text.data(), size, MPI_CHAR, &message, &received);
  finish(received, what);
  return text;
}

std::vector<double> Agreement::gather_on_side(std::vector<double> const& mine,
                                              char const* what) const {
  int const count = static_cast<int>(mine.size());
  std::vector<double> all(world_.rank == 0 ? mine.size() * world_.size : 0);
  MPI_Request request;
  MPI_Igather(mine.data(), count, MPI_DOUBLE, all.data(), count, MPI_DOUBLE, 0, world_.side,
              &request);
  finish(request, what);
  return all;
}

}  // namespace slidewave
