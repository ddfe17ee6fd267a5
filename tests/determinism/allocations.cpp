#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "coupling/viscosity.hpp"
#include "interaction/contact.hpp"
#include "random_cells.hpp"
#include "simulation/advance.hpp"
#include "small_run.hpp"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
    ++allocations;
    void* p = nullptr;
    if (posix_memalign(&p, alignment < sizeof(void*) ? sizeof(void*) : alignment, size) != 0)
        throw std::bad_alloc();
    return p;
}
}  // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t a) {
    return counted(size, static_cast<std::size_t>(a));
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace {

using namespace tt;

TEST(Allocations, none_in_the_viscosity_and_contact_passes_once_their_arrays_are_there) {
    const Lattice lattice{120, 90, true};
    for (const InterfaceViscosity& interface :
         {InterfaceViscosity{SmoothedInterface{}}, InterfaceViscosity{AreaFraction{}}}) {
        ViscosityModel viscosity;
        viscosity.interface = interface;
        ContactModel contact_model;
        contact_model.law = Morse{0.02, 0.77, 2.45, true};
        contact_model.range = 9.0;
        Suspension cells = random_cells::suspension(5, 4, 3, 30.0, 11.0, 70);
        Random random(6);
        InteriorState interior;
        Relaxation relaxation(lattice);
        ContactState contact;
        rebuild_viscosity(viscosity, cells, interior, relaxation);
        long before = 0;
        for (int n = 0; n < 200; ++n) {
            if (n == 100) before = allocations;
            random_cells::jiggle(cells, random, 0.02);
            add_pair_forces(contact_model, lattice, 0, cells, contact);
            lay_cytoplasm(viscosity, cells, interior);
            update_viscosity(viscosity, cells, interior, relaxation);
        }
        const long after = allocations;  // the assertions themselves allocate
        EXPECT_GT(before, 0);
        EXPECT_EQ(after, before);
    }
}

TEST(Allocations, none_in_a_step_once_its_arrays_are_there) {
    Model model = small_model();
    model.contact.law = Morse{1e-3, 0.77, 2.45, true};
    model.contact.range = 9.0;
    State state = small_state(model);
    Periodic exchange;
    long before = 0;
    for (int n = 0; n < 300; ++n) {
        if (n == 100) before = allocations;
        advance(model, state, exchange);
    }
    const long after = allocations;
    EXPECT_EQ(after, before);
}

}  // namespace
