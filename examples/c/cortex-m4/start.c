/* What comes before main on a Cortex-M4 under QEMU, which loads all memory and prints through
 * semihosting: the vectors, and the floating-point unit switched on. */
#include <stdint.h>
#include <stdlib.h>

extern void initialise_monitor_handles(void); /* newlib: opens the standard streams */
extern int main(void);
extern uint8_t stack_top[];

static void reset(void)
{
    volatile uint32_t *const cpacr = (volatile uint32_t *)0xE000ED88;
    *cpacr |= 0xFu << 20; /* full access to coprocessors 10 and 11 */
    __asm__ volatile("dsb\n\tisb");
    initialise_monitor_handles();
    exit(main());
}

static void fault(void)
{
    abort();
}

typedef union vector {
    const void *address;
    void (*handler)(void);
} vector;

__attribute__((section(".vectors"), used)) static const vector VECTORS[] = {
    {.address = stack_top}, {.handler = reset}, {.handler = fault}, {.handler = fault},
};
