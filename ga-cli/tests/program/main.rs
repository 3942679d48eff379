//! The program as an outsider sees it: what it prints, what it writes, how it fails.

mod arm;
mod crystal;
mod expand;
mod failures;
mod gallery;
mod group;
mod group_domain;
mod group_failures;
mod group_files;
mod group_unlisted;
mod group_versors;
mod run;
mod symmetry;
mod tensegrity;
