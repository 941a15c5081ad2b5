# SPDX-License-Identifier: MIT
# In the place of platform/mps2/boards.cmake: how QEMU's `virt` runs a program for a RISC-V CPU, with a field every MiB. Its
# FPU is off, so that an instruction of it would end the program.
function(lumi_mps2_command out)
  cmake_parse_arguments(PARSE_ARGV 1 run "" "CPU;PROGRAM" "FIELDS")
  set(command qemu-system-riscv32 -M virt -cpu rv32 -m 64M -bios none -display none -serial none -monitor none
    -chardev stdio,id=console -semihosting-config enable=on,target=native,chardev=console)
  set(address 0x81000000)  # lumi_fields of link.ld
  foreach(field IN LISTS run_FIELDS)
    string(REPLACE "," ",," field "${field}")
    list(APPEND command -device loader,file=${field},addr=${address},force-raw=on)
    math(EXPR address "${address} + 0x100000" OUTPUT_FORMAT HEXADECIMAL)
  endforeach()
  set(${out} ${command} -kernel ${run_PROGRAM} PARENT_SCOPE)
endfunction()
