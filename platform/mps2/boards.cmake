# SPDX-License-Identifier: MIT
# Which emulated board runs code for which CPU, and how. Used by the firmware's build and by the host's tests.
#
# Code for Cortex-M0+ runs on the Cortex-M3 board: QEMU's one ARMv6-M board (micro:bit) has 16 KB of RAM, and every
# ARMv6-M instruction is an ARMv7-M instruction. The start-up code makes unaligned accesses fault, as an M0+ does.
set(LUMI_MPS2_CPUS cortex-m0plus cortex-m3 cortex-m4 cortex-m7 cortex-m33 cortex-m55)
set(LUMI_MPS2_BOARD_cortex-m0plus an385)
set(LUMI_MPS2_BOARD_cortex-m3 an385)
set(LUMI_MPS2_BOARD_cortex-m4 an386)
set(LUMI_MPS2_BOARD_cortex-m7 an500)
set(LUMI_MPS2_BOARD_cortex-m33 an505)
set(LUMI_MPS2_BOARD_cortex-m55 an547)

# Where a board's memories lie: the vectors that its CPU reads first, code and how much there is of it, 4 MB for data,
# and the PSRAM where -device loader puts a large field, which loaded_field() of the board reads. MPS2 boards have 4 MB of
# SSRAM for code and as much for data, those of the Cortex-M33 at secure addresses. The MPS3 board has its vectors in
# ITCM, and code and field in its DDR.
function(lumi_mps2_memory board vectors code code_bytes data psram)
  set(LUMI_MPS2_PSRAM_${board} ${psram} PARENT_SCOPE)
  set(LUMI_MPS2_MEMORY_${board} -Wl,--defsym=lumi_vectors_at=${vectors},--defsym=lumi_code_at=${code}
    -Wl,--defsym=lumi_code_bytes=${code_bytes},--defsym=lumi_data_at=${data},--defsym=lumi_psram_start=${psram}
    PARENT_SCOPE)
endfunction()
lumi_mps2_memory(an385 0x00000000 0x00000100 0x003FFF00 0x20000000 0x21000000)
lumi_mps2_memory(an386 0x00000000 0x00000100 0x003FFF00 0x20000000 0x21000000)
lumi_mps2_memory(an500 0x00000000 0x00000100 0x003FFF00 0x20000000 0x60000000)
lumi_mps2_memory(an505 0x10000000 0x10000100 0x003FFF00 0x38000000 0x80000000)
lumi_mps2_memory(an547 0x10000000 0x70000000 0x01000000 0x31000000 0x71000000)

# These are QEMU's names of boards: the images up to 505 are of the MPS2, later ones of the MPS3.
foreach(board an385 an386 an500 an505)
  set(LUMI_MPS2_MACHINE_${board} mps2-${board})
endforeach()
set(LUMI_MPS2_MACHINE_an547 mps3-an547)

set(LUMI_MPS2_CLOCK_MHZ_an385 25)
set(LUMI_MPS2_CLOCK_MHZ_an386 25)
set(LUMI_MPS2_CLOCK_MHZ_an500 25)
set(LUMI_MPS2_CLOCK_MHZ_an505 20)
set(LUMI_MPS2_CLOCK_MHZ_an547 32)

# lumi_mps2_command(OUT CPU cpu PROGRAM file [ARGUMENTS a...] [FIELDS file...] [COUNT_INSTRUCTIONS])
# The command, as a list, that runs a program. Its semihosting output goes to standard output through a channel of its
# own (QEMU would send it to standard error). Fields are loaded into PSRAM, one after every MiB.
# COUNT_INSTRUCTIONS: one virtual nanosecond an instruction, so that SysTick counts them; slower.
function(lumi_mps2_command out)
  cmake_parse_arguments(PARSE_ARGV 1 run "COUNT_INSTRUCTIONS" "CPU;PROGRAM" "ARGUMENTS;FIELDS")
  set(board ${LUMI_MPS2_BOARD_${run_CPU}})
  set(semihosting enable=on,target=native,chardev=console,arg=program)
  foreach(argument IN LISTS run_ARGUMENTS)
    string(REPLACE "," ",," argument "${argument}")
    string(APPEND semihosting ",arg=${argument}")
  endforeach()
  set(command qemu-system-arm -M ${LUMI_MPS2_MACHINE_${board}} -display none -serial none -monitor none
    -chardev stdio,id=console -semihosting-config ${semihosting})
  if(run_COUNT_INSTRUCTIONS)
    list(APPEND command -icount shift=0)
  endif()
  set(address ${LUMI_MPS2_PSRAM_${board}})
  foreach(field IN LISTS run_FIELDS)
    string(REPLACE "," ",," field "${field}")
    list(APPEND command -device loader,file=${field},addr=${address},force-raw=on)
    math(EXPR address "${address} + 0x100000" OUTPUT_FORMAT HEXADECIMAL)
  endforeach()
  set(${out} ${command} -kernel ${run_PROGRAM} PARENT_SCOPE)
endfunction()
