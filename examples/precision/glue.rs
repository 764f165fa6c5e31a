//! Code next to a chain for what its public traits do not provide: inputs from a list of numbers, and
//! access to its results by name.

use mstmm_codegen::model::{Chain, Dimension, Input, InputKind, Layout, ViewArgument};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::model::times;

/// The type that the program finds in the library. Its traits are visible everywhere, in whichever
/// module the chain is and whatever its visibility is.
pub const ANCHOR: &str = "pub struct MstmmPrecision;\n";

/// Returns the code that follows a chain, on one line.
pub fn code(chain: &Chain) -> String {
    let (name, workspace) = (&chain.name, format_ident!("{}Workspace", chain.name));
    let point = match chain.dimension {
        Dimension::Space => quote!(Point),
        Dimension::Plane => quote!(PlanePoint),
        Dimension::Line => quote!(LinePoint),
    };
    let fields = Layout::of(chain).inputs.into_iter().scan(0, |first, input| {
        let (field, each) = (chain.name_of_input(input.what), input.range.len());
        let count = times(chain, input.what);
        let (here, value) = (*first, value(chain, &input));
        *first += each * count.unwrap_or(1);
        Some(match count {
            None => quote! {
                let n = |k: usize| <T as ::mstmm::Scalar>::constant(given[#here + k]);
                inputs.#field = #value;
            },
            Some(_) => quote! {
                inputs.#field = ::core::array::from_fn(|time| {
                    let n = |k: usize| {
                        <T as ::mstmm::Scalar>::constant(given[#here + #each * time + k])
                    };
                    #value
                });
            },
        })
    });
    let code = quote! {
        #[allow(warnings)]
        const _: () = {
            impl<T: ::mstmm_precision::Number> ::mstmm_precision::Subject for #name<T> {
                type Point = ::mstmm::#point<T>;

                fn inputs(given: &[f64]) -> <Self as ::mstmm::Chain>::Inputs {
                    let mut inputs: <Self as ::mstmm::Chain>::Inputs =
                        ::core::default::Default::default();
                    #(#fields)*
                    inputs
                }

                fn points(at: &#workspace<T>) -> ::std::vec::Vec<::mstmm::#point<T>> {
                    at.points().to_vec()
                }

                fn energy_at(at: &#workspace<T>) -> ::mstmm::Energy<T> {
                    let (kinetic, potential) = (at.kinetic_energy(), at.potential_energy());
                    ::mstmm::Energy { kinetic, potential }
                }
            }

            impl ::mstmm_precision::Chosen for crate::MstmmPrecision {
                fn compare() -> ::mstmm_precision::ExitCode {
                    ::mstmm_precision::compare::<#name<f64>, #name<f32>>()
                }
            }
        };
    };
    code.to_string().replace('\n', " ")
}

/// Returns one input from its numbers `n(0)`, `n(1)`, ….
fn value(chain: &Chain, input: &Input) -> TokenStream {
    let InputKind::Motion(hinge) = input.what else {
        return numbers(0, input.range.len(), true);
    };
    let kind = &chain.hinges[hinge].kind;
    let (coordinates, dof_count) = (kind.coordinates(), kind.dof_count());
    let Some(view) = &kind.spec().view else { return TokenStream::new() };
    let name = format_ident!("{}", view.name);
    let groups = view.groups.iter().map(|group| match group {
        ViewArgument::Coordinates(range) => numbers(range.start, range.len(), false),
        ViewArgument::Rates(range) => numbers(coordinates + range.start, range.len(), false),
    });
    let acceleration = numbers(coordinates + dof_count, dof_count, true);
    quote! {
        ::mstmm::HingeMotion {
            state: ::mstmm::#name::new(#(#groups),*),
            acceleration: #acceleration,
        }
    }
}

/// Returns a number, or several numbers in an array or a vector.
fn numbers(first: usize, count: usize, vector: bool) -> TokenStream {
    let all = first..first + count;
    match (count, vector) {
        (1, _) => quote!(n(#first)),
        (_, false) => quote!([#(n(#all)),*]),
        (_, true) => quote!(::mstmm::nalgebra::SVector::from([#(n(#all)),*])),
    }
}
